//! The columns of coordinates where a heading says which they are, among other columns of numbers.

use crate::commands::import::format::fields::{BETWEEN_COLUMNS, is_number};
use crate::commands::import::format::heading::with_axes_apart;
use crate::commands::import::spelling::spelled;
use crate::vehicle_corner::Section;

/// The columns of x, y and z, which are beside each other: those of one point, or of one in each group of columns.
#[derive(Debug)]
pub(super) struct CoordinateColumns {
    separator: char,
    /// The number of all columns.
    count: usize,
    /// The column of x in each group.
    x: Vec<usize>,
}

impl CoordinateColumns {
    /// Returns the columns that a heading names; `None` if it names none.
    pub(super) fn of_heading(line: &str) -> Option<Self> {
        let mut found = BETWEEN_COLUMNS.into_iter().filter_map(|separator| {
            let cells: Vec<String> = line
                .split(separator)
                .map(|cell| with_axes_apart(&spelled(cell)))
                .collect();
            let is = |column: usize, axis: &str| {
                let cell = cells.get(column);
                cell.is_some_and(|cell| cell.split('_').any(|word| word == axis))
            };
            let columns = 0..cells.len();
            let x: Vec<usize> = columns.filter(|column| is(*column, "x")).collect();
            let mut groups = x.iter();
            let is_whole = groups.all(|x| is(x + 1, "y") && is(x + 2, "z"));
            let count = cells.len();
            (is_whole && !x.is_empty()).then_some(Self {
                separator,
                count,
                x,
            })
        });
        found.next()
    }

    /// Returns a line without the numbers in other columns, for example indices and masses. A line with more or fewer columns
    /// than the heading stays as it is, for the heading may have none above the names.
    pub(super) fn without_others(&self, line: &str) -> String {
        let Some(cells) = self.cells(line) else {
            return line.to_owned();
        };
        let kept = cells.iter().enumerate().map(|(column, cell)| {
            let is_other = is_number(cell) && !self.is_coordinate(column);
            if is_other { "" } else { cell }
        });
        kept.collect::<Vec<_>>().join(&self.separator.to_string())
    }

    /// Returns those of the `groups` in which a line has a number, as where a rear axle has fewer points than the front one.
    pub(super) fn filled(&self, line: &str, groups: &[Section]) -> Vec<Section> {
        let Some(cells) = self.cells(line).filter(|_| self.x.len() == groups.len()) else {
            return groups.to_vec();
        };
        let is_filled = |x: &usize| cells[*x..x + 3].iter().any(|cell| is_number(cell));
        let filled = self.x.iter().zip(groups).filter(|(x, _)| is_filled(x));
        filled.map(|(_, group)| *group).collect()
    }

    /// Returns the cells of a line that has as many as the heading, with a coordinate among them, and no separator in quotes.
    fn cells<'a>(&self, line: &'a str) -> Option<Vec<&'a str>> {
        let cells: Vec<&str> = line.split(self.separator).collect();
        let mut numbers = (0..cells.len()).filter(|column| is_number(cells[*column]));
        let is_whole = |cell: &&str| cell.matches('"').count().is_multiple_of(2);
        let is_row = cells.len() == self.count && cells.iter().all(is_whole);
        (is_row && numbers.any(|column| self.is_coordinate(column))).then_some(cells)
    }

    fn is_coordinate(&self, column: usize) -> bool {
        self.x.iter().any(|x| (*x..x + 3).contains(&column))
    }
}
