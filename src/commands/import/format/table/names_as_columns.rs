//! Tables with the names of points as columns and a line for each of x, y and z.

use std::ops::Range;

use crate::commands::import::format::fields::{BETWEEN_COLUMNS, is_number};
use crate::commands::import::format::lines::Line;
use crate::commands::import::length_units::is_unit;
use crate::commands::import::names::Names;
use crate::commands::import::spelling::{key_of, spelled};
use crate::vehicle_corner::Section;

/// Puts a line for each point in place of lines with x, y and z below a line of names, which may stand over several such blocks.
pub(super) fn with_names_in_rows<'a>(
    lines: impl Iterator<Item = Line<'a>>,
    known: &Names,
) -> Vec<Line<'a>> {
    let mut rows: Vec<Line<'a>> = Vec::new();
    let mut names: Option<Line<'a>> = None;
    for line in lines {
        rows.push(line);
        let Some((before, block)) = rows.split_last_chunk::<3>() else {
            continue;
        };
        let mut above = before.last().into_iter().chain(&names);
        let found = above.find_map(|above| Some((rows_of(above, block, known)?, above.clone())));
        if let Some((points, above)) = found {
            let is_above = before.last() == Some(&above);
            rows.truncate(before.len() - usize::from(is_above));
            rows.extend(points);
            names = Some(above);
        }
    }
    rows
}

/// Returns a heading of columns, one with the corner, if the block names it, and a line for each point; `None` unless
/// the lines have x, y and z of several points below their names.
fn rows_of<'a>(names: &Line<'a>, block: &[Line<'a>; 3], known: &Names) -> Option<Vec<Line<'a>>> {
    let [x, y, z] = block;
    let place = x.0.start..z.0.end;
    BETWEEN_COLUMNS.into_iter().find_map(|separator| {
        let lines = [names, x, y, z].map(|line| cells(line, separator));
        let block = Block::read(&lines).filter(|block| block.is_of_points(known))?;
        let headings = [block.heading.join("; "), block.corner];
        let headings = headings.map(|words| (place.clone(), words.into()));
        let points = block.points.into_iter().map(|(column, point)| {
            let place = place_of_cell(x, separator, column);
            (place, point.join("; ").into())
        });
        Some(headings.into_iter().chain(points).collect())
    })
}

/// Lines of names, x, y and z, by columns.
struct Block<'b> {
    /// The column that says which line is that of x.
    heading: [&'b str; 4],
    /// The words beside `x` in this column and before it.
    corner: String,
    /// The columns that have a name, with their places.
    points: Vec<(usize, [&'b str; 4])>,
}

impl<'b> Block<'b> {
    fn read(lines: &[Vec<&'b str>; 4]) -> Option<Self> {
        let [names, axes @ ..] = lines;
        let label = label_column(axes)?;
        let column = |column: usize| {
            let cells = lines.each_ref().map(|cells| cells.get(column).copied());
            cells.map(Option::unwrap_or_default)
        };
        let columns = (label + 1..names.len()).map(|at| (at, column(at)));
        let is_point = |(_, [name, at @ ..]): &(usize, [&str; 4])| {
            !name.is_empty() && !is_number(name) && *at != [""; 3]
        };
        Some(Self {
            heading: column(label),
            corner: corner(&axes[0][..=label]),
            points: columns.filter(is_point).collect(),
        })
    }

    /// Returns whether the columns are those of points, or of corners beside a point: of a list of parameters such as
    /// `lca_front_x; 130; 120; 140` they are a value and its limits.
    fn is_of_points(&self, known: &Names) -> bool {
        let is_whole = |[_, at @ ..]: [&str; 4]| at.into_iter().all(is_number);
        let whole = self.points.iter().filter(|(_, point)| is_whole(*point));
        let mut names = self.points.iter().map(|(_, [name, ..])| spelled(name));
        let is_of_parameter = known.is_point(&key_of(&self.corner).0);
        whole.count() > 1
            && (!is_of_parameter || names.all(|name| Section::of_word(&name).is_some()))
    }
}

/// Returns the place of a cell and what is behind it in its line.
fn place_of_cell(line: &Line<'_>, separator: char, column: usize) -> Range<usize> {
    let before = line.1.split(separator).take(column);
    let start: usize = before.map(|cell| cell.len() + separator.len_utf8()).sum();
    line.0.start + start.min(line.1.len())..line.0.end
}

/// Returns the cells of a line without the blanks and quotes around them.
fn cells<'a>(line: &'a Line<'_>, separator: char) -> Vec<&'a str> {
    let cells = line.1.split(separator);
    let around = |c: char| c.is_whitespace() || "'\"".contains(c);
    cells.map(|cell| cell.trim_matches(around)).collect()
}

/// Returns the column in which three lines say that they are those of x, y and z.
fn label_column(block: &[Vec<&str>; 3]) -> Option<usize> {
    let is = |cells: &[&str], column: usize, axis: &str| {
        let words = cells.get(column).map(|cell| spelled(cell));
        words.is_some_and(|words| words.split('_').any(|word| word == axis))
    };
    let [x, y, z] = block;
    (0..x.len()).find(|column| is(x, *column, "x") && is(y, *column, "y") && is(z, *column, "z"))
}

/// Returns the words of the label of a line, and of the cells before it, but its axis and unit.
fn corner(cells: &[&str]) -> String {
    let words = spelled(&cells.join(" "));
    let words = words
        .split('_')
        .filter(|word| *word != "x" && !is_unit(word));
    words.collect::<Vec<_>>().join(" ")
}
