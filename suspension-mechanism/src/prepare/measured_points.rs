//! Measured or recorded points in a CSV file.

use suspension_listing::did_you_mean::unknown;
use toml::Spanned;

use crate::failure::Failure;
use crate::file::{CsvTable, Source};
use crate::measured_table::MeasuredTable;
use crate::measured_table::units::{name_and_symbol, usual_symbol};
use crate::number::number;

/// Two columns of a table, perhaps below a line of units.
pub(super) struct MeasuredPoints {
    table: MeasuredTable,
    columns: [usize; 2],
    units: Vec<String>,
}

impl MeasuredPoints {
    /// Finds the two columns that a motion file names; `of` says what they hold, with an example.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at the path, and at a column that the file does not have, or has twice.
    pub(super) fn find(source: &Source, stated: &CsvTable, of: &str) -> Result<Self, Failure> {
        let [at, value] = stated.columns.get_ref().as_slice() else {
            let message = format!("`columns` are two headings of the file, {of}");
            return Err(source.refuse(&stated.columns.span(), message));
        };
        let mut table = MeasuredTable::new(&source.read_table_beside(&stated.csv)?)?;
        let column = |wanted: &Spanned<String>| {
            let found = column(&table, wanted.get_ref());
            found.map_err(|message| source.refuse(&wanted.span(), message))
        };
        Ok(Self {
            columns: [column(at)?, column(value)?],
            units: table.take_units(),
            table,
        })
    }

    /// Refuses one of the columns that states another unit than the one wanted, in its heading or in the line of units.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at the heading, with the remedy.
    pub(super) fn check_unit(
        &self,
        which: usize,
        wanted: &str,
        remedy: impl Fn(&str) -> String,
    ) -> Result<(), Failure> {
        let column = self.columns[which];
        let heading = self.table.headings()[column];
        let below = self.units.get(column).map_or("", String::as_str);
        match stated_unit(heading, below) {
            Some(stated) if stated != wanted => {
                let remedy = remedy(&stated);
                let message = format!("`{heading}` is in {stated}, not in {wanted}: {remedy}");
                Err(self.table.refuse_heading(column, message))
            }
            _ => Ok(()),
        }
    }

    /// The numbers of the columns, line by line.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at a line without a number in a column.
    pub(super) fn numbers(&self) -> Result<Vec<[f64; 2]>, Failure> {
        let [at, value] = self.columns;
        let (places, values) = (self.table.numbers(at)?, self.table.numbers(value)?);
        Ok(places
            .into_iter()
            .zip(values)
            .map(|(at, value)| [at, value])
            .collect())
    }

    /// Refuses times, the first of these numbers, that do not increase from line to line.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at the first time that is not later than the one above it.
    pub(super) fn check_times(&self, numbers: &[[f64; 2]]) -> Result<(), Failure> {
        let is_late = |two: &[[f64; 2]]| two[0][0] >= two[1][0];
        let Some(above) = numbers.windows(2).position(is_late) else {
            return Ok(());
        };
        let [before, after] = [numbers[above][0], numbers[above + 1][0]].map(number);
        let message = format!(
            "times must increase, but {after} s follows {before} s; leave out one of the lines, or correct the time"
        );
        Err(self
            .table
            .refuse_number(above + 1, self.columns[0], message))
    }
}

/// Returns the column of a heading, or a sentence with the remedy if the table does not have it once.
fn column(table: &MeasuredTable, wanted: &str) -> Result<usize, String> {
    let headings = table.headings();
    let mut found = (0..headings.len()).filter(|column| headings[*column] == wanted);
    let name = table.name();
    match (found.next(), found.next()) {
        (Some(only), None) => Ok(only),
        (Some(first), Some(second)) => Err(format!(
            "columns {} and {} of {name} are both called `{wanted}`; rename one",
            first + 1,
            second + 1
        )),
        (None, _) => Err(match table.line_with(wanted) {
            Some(line) => format!(
                "`{wanted}` is in line {line} of {name}, below the first line of several fields, which has the headings; begin the \
                 lines above it with #"
            ),
            None => unknown(&format!("column of {name}:"), wanted, &headings),
        }),
    }
}

/// Symbols that are units wherever a heading has them; others, such as `h` and `min`, may be part of a name.
const UNITS: [&str; 11] = [
    "s", "ms", "us", "\u{b5}s", "m", "mm", "cm", "in", "rad", "mrad", "deg",
];

/// The unit of a column according to its heading, as `travel [mm]` or `travel_mm`, or to the line `below` it.
fn stated_unit(heading: &str, below: &str) -> Option<String> {
    let symbol = match name_and_symbol(heading, below) {
        // `steer_in` may be an input.
        (name, "") => name.rsplit_once('_').filter(|(_, end)| *end != "in")?.1,
        (_, symbol) => symbol,
    };
    Some(usual_symbol(symbol)).filter(|symbol| UNITS.contains(&symbol.as_str()))
}
