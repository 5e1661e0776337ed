//! Rows of numbers as Parquet: each quantity is a column of `f64`, null where it has no value, and a description is stored as
//! the file's metadata.
//!
//! This crate is separate so that the program is built without it unless a feature enables it.
#![forbid(unsafe_code)]

use std::io::Write;
use std::sync::Arc;

use parquet::basic::{Repetition, Type as Physical};
use parquet::data_type::DoubleType;
use parquet::errors::Result;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

pub use parquet::errors::ParquetError;

/// The number of rows that are written at once.
pub const GROUP: usize = 65_536;

/// A table that is being written.
pub struct Table<W: Write + Send> {
    writer: SerializedFileWriter<W>,
    /// The columns of the rows that are not written yet.
    columns: Vec<Vec<f64>>,
}

impl<W: Write + Send> Table<W> {
    /// Starts a table with the names of its columns and a description.
    ///
    /// # Errors
    ///
    /// If the writer fails, or a name cannot be that of a column.
    pub fn create<'a>(
        to: W,
        columns: impl IntoIterator<Item = &'a str>,
        about: impl IntoIterator<Item = (&'a str, &'a str)>,
    ) -> Result<Self> {
        let column = |name: &str| {
            let column = Type::primitive_type_builder(name, Physical::DOUBLE);
            let column = column.with_repetition(Repetition::OPTIONAL).build();
            column.map(Arc::new)
        };
        let columns: Vec<_> = columns.into_iter().map(column).collect::<Result<_>>()?;
        let count = columns.len();
        let schema = Type::group_type_builder("rows").with_fields(columns);
        let about = about.into_iter();
        let about = about.map(|(key, value)| KeyValue::new(key.to_owned(), value.to_owned()));
        let properties = WriterProperties::builder().set_key_value_metadata(Some(about.collect()));
        Ok(Self {
            writer: SerializedFileWriter::new(
                to,
                Arc::new(schema.build()?),
                Arc::new(properties.build()),
            )?,
            columns: vec![Vec::new(); count],
        })
    }

    /// Adds a row with one number per column; NaN is written as null.
    ///
    /// # Errors
    ///
    /// If the writer fails.
    pub fn row(&mut self, values: &[f64]) -> Result<()> {
        for (column, value) in self.columns.iter_mut().zip(values) {
            column.push(*value);
        }
        match self.columns.first() {
            Some(column) if column.len() == GROUP => self.write(),
            _ => Ok(()),
        }
    }

    /// Ends the table.
    ///
    /// # Errors
    ///
    /// If the writer fails.
    pub fn finish(mut self) -> Result<W> {
        // Some readers refuse a group without rows.
        if self.columns.iter().any(|column| !column.is_empty()) {
            self.write()?;
        }
        self.writer.into_inner()
    }

    fn write(&mut self) -> Result<()> {
        let mut group = self.writer.next_row_group()?;
        let mut columns = self.columns.iter_mut();
        while let Some(mut column) = group.next_column()? {
            if let Some(values) = columns.next() {
                let is_there: Vec<i16> = values.iter().map(|x| i16::from(!x.is_nan())).collect();
                values.retain(|value| !value.is_nan());
                let column = column.typed::<DoubleType>();
                column.write_batch(values, Some(&is_there), None)?;
                values.clear();
            }
            column.close()?;
        }
        group.close()?;
        Ok(())
    }
}
