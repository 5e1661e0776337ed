//! The columns of coordinates where a heading says which they are, among other columns of numbers.

use super::fields::is_number;
use super::names::spelled;

/// The columns of x, y and z, which are beside each other.
#[derive(Debug)]
pub(super) struct Columns {
    separator: char,
    /// The number of all columns.
    count: usize,
    x: usize,
}

impl Columns {
    /// Returns the columns that a heading names; `None` if it names none, or has several columns of one axis.
    pub(super) fn of_heading(line: &str) -> Option<Self> {
        let separators = [';', '\t', '|', ','].into_iter();
        let mut found = separators.filter_map(|separator| {
            let cells: Vec<String> = line.split(separator).map(spelled).collect();
            let is = |cell: &String, axis: &str| cell.split('_').any(|word| word == axis);
            let mut of_x = (0..cells.len()).filter(|column| is(&cells[*column], "x"));
            let (Some(x), None) = (of_x.next(), of_x.next()) else {
                return None;
            };
            let is_beside = is(cells.get(x + 1)?, "y") && is(cells.get(x + 2)?, "z");
            is_beside.then_some(Self {
                separator,
                count: cells.len(),
                x,
            })
        });
        found.next()
    }

    /// Returns a line without the numbers in other columns, for example indices and masses. A line with more or fewer columns
    /// than the heading stays as it is, for the heading may have none above the names.
    pub(super) fn without_others(&self, line: &str) -> String {
        let cells: Vec<&str> = line.split(self.separator).collect();
        let is_coordinate = |column: usize| (self.x..self.x + 3).contains(&column);
        let mut numbers = (0..cells.len()).filter(|column| is_number(cells[*column]));
        if cells.len() != self.count || !numbers.any(is_coordinate) || line.contains('"') {
            return line.to_owned();
        }
        let kept = cells.iter().enumerate().map(|(column, cell)| {
            let is_other = is_number(cell) && !is_coordinate(column);
            if is_other { "" } else { cell }
        });
        kept.collect::<Vec<_>>().join(&self.separator.to_string())
    }
}
