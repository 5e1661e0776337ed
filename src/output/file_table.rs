//! A table in files: one row per item, with columns computed from the item.

use crate::failure::Failure;
use crate::file::Dimension;
use crate::mechanism::{State, Unit};
use crate::output::heading::{Header, Heading};
use crate::output::rows::{Rows, TableTargets};
use crate::quantities::{self, value_in_file};

/// A column: a name and a function from an item to a number.
pub struct Column<T> {
    heading: Heading,
    value: Box<dyn Fn(&T) -> f64>,
}

impl<T: 'static> Column<T> {
    /// Makes a column of real numbers.
    pub fn new(name: impl Into<String>, value: fn(&T) -> f64) -> Self {
        Self {
            heading: Heading::new(name),
            value: Box::new(value),
        }
    }

    /// Makes a column of whole numbers.
    pub fn of_counts(name: impl Into<String>, value: fn(&T) -> f64) -> Self {
        let mut column = Self::new(name, value);
        column.heading.counts = true;
        column
    }

    /// Makes the column of a quantity of the catalogue, from the state of an item.
    pub fn of_state(column: quantities::Column, unit: Unit, state: fn(&T) -> &State) -> Self {
        Self {
            heading: Heading {
                name: column.csv_name(unit),
                counts: column.dimension == Dimension::Count,
            },
            value: Box::new(move |thing| value_in_file(&column, state(thing), unit)),
        }
    }
}

/// A table that is being written.
pub struct Table<T> {
    rows: Rows,
    columns: Vec<Column<T>>,
    row: Vec<f64>,
}

impl<T: 'static> Table<T> {
    /// Starts a table in the requested formats; without any, nothing is computed.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn create(
        tables: &TableTargets,
        header: &Header,
        mut columns: Vec<Column<T>>,
    ) -> Result<Self, Failure> {
        if tables.is_empty() {
            columns.clear();
        }
        let headings = columns.iter().map(|column| column.heading.clone());
        Ok(Self {
            rows: Rows::create(tables, header, &headings.collect::<Vec<_>>())?,
            columns,
            row: Vec::new(),
        })
    }

    /// Adds the row of an item.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn add(&mut self, thing: &T) -> Result<(), Failure> {
        self.row.clear();
        let values = self.columns.iter().map(|column| (column.value)(thing));
        self.row.extend(values);
        self.rows.add(&self.row)
    }

    /// Ends the table; a file gets its name.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn finish(self) -> Result<(), Failure> {
        self.rows.finish()
    }
}
