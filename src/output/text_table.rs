//! Text tables for people: columns two spaces apart, each as wide as its widest text.

use crate::file::Dimension;
use crate::mechanism::Unit;
use crate::number::{aligned, fixed};

/// The distance between columns.
const GAP: usize = 2;

/// A column: its heading and its cells.
#[derive(Clone)]
pub struct TextColumn {
    heading: String,
    cells: Vec<String>,
    is_at_right: bool,
}

impl TextColumn {
    /// Makes a column of left-aligned texts.
    pub fn left(cells: impl IntoIterator<Item = impl ToString>) -> Self {
        Self {
            heading: String::new(),
            cells: cells.into_iter().map(|cell| cell.to_string()).collect(),
            is_at_right: false,
        }
    }

    /// Makes a column of right-aligned texts.
    pub fn right(cells: impl IntoIterator<Item = impl ToString>) -> Self {
        Self {
            is_at_right: true,
            ..Self::left(cells)
        }
    }

    /// Makes a column of numbers with aligned decimal points and a right-aligned heading.
    pub fn numbers(numbers: impl IntoIterator<Item = String>) -> Self {
        Self::right(aligned(numbers.into_iter().collect(), [' ', ' ']))
    }

    /// Makes a column of values in the unit of summaries, with the decimals that suit it.
    pub fn values(values: impl Iterator<Item = f64>, dimension: Dimension, unit: Unit) -> Self {
        let ((scale, _), decimals) = (dimension.display_scale(unit), dimension.decimals(unit));
        Self::right(values.map(|value| fixed(value * scale, decimals)))
    }

    /// Sets the heading.
    pub fn headed(self, heading: impl Into<String>) -> Self {
        let heading = heading.into();
        Self { heading, ..self }
    }

    /// Sets the heading and, in a line of its own below it, the unit.
    pub fn headed_with_unit(mut self, heading: &str, unit: &str) -> Self {
        self.cells.insert(0, format!("({unit})"));
        self.headed(heading)
    }

    fn width(&self) -> usize {
        let texts = [&self.heading].into_iter().chain(&self.cells);
        texts.map(|text| text.chars().count()).max().unwrap_or(0)
    }

    /// Joins the cells of another column to this one's, for example units; the heading becomes left-aligned.
    pub fn joined(self, between: &str, next: Self) -> Self {
        let cells = self.cells.iter().zip(next.cells);
        let cells = cells.map(|(cell, next)| format!("{cell}{between}{next}"));
        Self::left(cells).headed(self.heading)
    }

    /// Returns the heading and the cells, padded to the same width.
    fn padded(&self) -> Vec<String> {
        let texts = || [&self.heading].into_iter().chain(&self.cells);
        let width = self.width();
        let padded = texts().map(|text| match self.is_at_right {
            true => format!("{text:>width$}"),
            false => format!("{text:width$}"),
        });
        padded.collect()
    }
}

/// Returns columns of the same number of cells as lines, indented: the headings, if there are any, and the cells.
pub fn laid_out(indent: usize, columns: impl IntoIterator<Item = TextColumn>) -> String {
    let columns = Vec::from_iter(columns);
    let is_without_headings = columns.iter().all(|column| column.heading.is_empty());
    let columns: Vec<Vec<String>> = columns.iter().map(TextColumn::padded).collect();
    let lines = columns.iter().map(Vec::len).min().unwrap_or(0);
    let line = |line: usize| {
        let texts: Vec<&str> = columns.iter().map(|column| column[line].as_str()).collect();
        let line = format!("{:indent$}{}", "", texts.join(&" ".repeat(GAP)));
        line.trim_end().to_owned() + "\n"
    };
    let lines = usize::from(is_without_headings)..lines;
    lines.map(line).collect()
}

/// Returns a table in parts side by side that are at most `width` characters wide where that is possible: each part has the
/// first column and as many of the others as fit, and an empty line follows each but the last.
pub fn in_parts(
    indent: usize,
    width: usize,
    first: &TextColumn,
    others: Vec<TextColumn>,
) -> String {
    let start = indent + first.width();
    let mut parts: Vec<Vec<TextColumn>> = Vec::new();
    let mut end = width;
    for column in others {
        end += GAP + column.width();
        match parts.last_mut().filter(|_| end <= width) {
            Some(part) => part.push(column),
            None => {
                end = start + GAP + column.width();
                parts.push(vec![first.clone(), column]);
            }
        }
    }
    let parts = parts.into_iter().map(|part| laid_out(indent, part));
    parts.collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    const NONE: [&str; 0] = [];

    fn numbers(numbers: &[&str]) -> TextColumn {
        TextColumn::numbers(numbers.iter().map(|number| (*number).to_owned()))
    }

    #[test]
    fn a_table_without_rows_prints_its_headings_alone() {
        assert_eq!(laid_out(2, []), "");
        assert_eq!(
            laid_out(2, [TextColumn::left(NONE), TextColumn::right(NONE)]),
            ""
        );
        let headed = [
            TextColumn::left(NONE).headed("name"),
            TextColumn::right(NONE),
        ];
        assert_eq!(laid_out(2, headed), "  name\n");
    }

    #[test]
    fn a_wide_table_has_parts_with_the_first_column() {
        let column = |name: &str| numbers(&["1", "22"]).headed_with_unit(name, "mm");
        let [t, x, y, z] = ["t", "x", "why", "zed"].map(column);
        let expected = "\
            \x20   t     x   why\n\
            \x20(mm)  (mm)  (mm)\n\
            \x20   1     1     1\n\
            \x20  22    22    22\n\n\
            \x20   t   zed\n\
            \x20(mm)  (mm)\n\
            \x20   1     1\n\
            \x20  22    22\n";
        assert_eq!(in_parts(1, 17, &t, vec![x, y, z]), expected);
    }

    #[test]
    fn column_width_counts_characters_rather_than_bytes() {
        let columns = [
            TextColumn::left(["Lenker", "Höhe", "Größe"]),
            TextColumn::right(["größer", "1", "22"]),
        ];
        let expected = "Lenker  größer\nHöhe         1\nGröße       22\n";
        assert_eq!(laid_out(0, columns), expected);
    }

    #[test]
    fn wide_headings_are_aligned_like_their_cells() {
        let columns = [
            TextColumn::left(["a", "b"]).headed("measure"),
            numbers(&["1.25", "-10"]).headed("in all"),
            TextColumn::right([7, 12]).headed("  no"),
            TextColumn::left(["m", ""]),
        ];
        let expected = "\
            \x20measure  in all    no\n\
            \x20a          1.25     7  m\n\
            \x20b        -10       12\n";
        assert_eq!(laid_out(1, columns), expected);
    }

    #[test]
    fn text_after_numbers_is_aligned() {
        let range = numbers(&["1.5", "-20"]).joined(" to ", numbers(&["300", "0.25"]));
        let range = range
            .headed("from")
            .joined(" ", TextColumn::left(["N", "N m"]));
        let expected = "from\n  1.5 to 300    N\n-20   to   0.25 N m\n";
        assert_eq!(laid_out(0, [range]), expected);
    }
}
