//! A table in a CSV file: a row a thing, each column read off the thing.

use crate::failure::Failure;
use crate::mechanism::{State, Unit};
use crate::output::csv_file::{CsvFile, Heading, Target};
use crate::quantities::{self, Kind};

/// A column of numbers that are read off things.
pub struct Column<T> {
    heading: Heading,
    value: Box<dyn Fn(&T) -> f64>,
}

impl<T: 'static> Column<T> {
    /// Numbers with a fraction, under a name.
    pub fn new(name: impl Into<String>, value: fn(&T) -> f64) -> Self {
        Self {
            heading: Heading {
                name: name.into(),
                counts: false,
            },
            value: Box::new(value),
        }
    }

    /// Counts, under a name.
    pub fn of_counts(name: impl Into<String>, value: fn(&T) -> f64) -> Self {
        let mut column = Self::new(name, value);
        column.heading.counts = true;
        column
    }

    /// One of the catalogue's, of the state of the thing.
    pub fn of_state(column: quantities::Column, unit: Unit, state: fn(&T) -> &State) -> Self {
        Self {
            heading: Heading {
                name: column.csv_name(unit),
                counts: column.kind == Kind::Count,
            },
            value: Box::new(move |thing| column.value(state(thing))),
        }
    }
}

/// A table being written.
pub struct Table<T> {
    file: CsvFile,
    columns: Vec<Column<T>>,
    row: Vec<f64>,
}

impl<T: 'static> Table<T> {
    /// Starts a table with its header.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn create(target: &Target, columns: Vec<Column<T>>) -> Result<Self, Failure> {
        let headings: Vec<_> = columns.iter().map(|column| &column.heading).collect();
        Ok(Self {
            file: CsvFile::create(target, &headings)?,
            columns,
            row: Vec::new(),
        })
    }

    /// Adds the row of a thing.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn add(&mut self, thing: &T) -> Result<(), Failure> {
        self.row.clear();
        let values = self.columns.iter().map(|column| (column.value)(thing));
        self.row.extend(values);
        self.file.row(&self.row)
    }

    /// Ends the table; a file takes its name.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn finish(self) -> Result<(), Failure> {
        self.file.finish()
    }
}
