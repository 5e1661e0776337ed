//! Rows of numbers as Parquet: each quantity is a column of `f64`, null where it has no value, and a description is stored as
//! the file's metadata.
//!
//! This crate is separate so that the program is built without it unless a feature enables it.
#![forbid(unsafe_code)]

use std::io::{self, Write};
use std::sync::Arc;

use parquet::basic::{Repetition, Type as Physical};
use parquet::data_type::DoubleType;
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

/// The number of rows that are written at once.
pub const GROUP: usize = 65_536;

/// A table that is being written.
pub struct Table<W: Write + Send> {
    writer: SerializedFileWriter<Held<W>>,
    /// The columns of the rows that are not written yet.
    columns: Vec<Vec<f64>>,
}

impl<W: Write + Send> Table<W> {
    /// Starts a table with the names of its columns and a description.
    ///
    /// # Errors
    ///
    /// The error of the writer, or another one if a name cannot be that of a column.
    pub fn create<'a>(
        to: W,
        columns: impl IntoIterator<Item = &'a str>,
        about: impl IntoIterator<Item = (&'a str, &'a str)>,
    ) -> io::Result<Self> {
        Self::started(to, columns, about).map_err(of_writer)
    }

    fn started<'a>(
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
                Held(Some(to)),
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
    /// The error of the writer.
    pub fn row(&mut self, values: &[f64]) -> io::Result<()> {
        for (column, value) in self.columns.iter_mut().zip(values) {
            column.push(*value);
        }
        match self.columns.first() {
            Some(column) if column.len() == GROUP => self.write().map_err(of_writer),
            _ => Ok(()),
        }
    }

    /// Ends the table.
    ///
    /// # Errors
    ///
    /// The error of the writer.
    pub fn finish(mut self) -> io::Result<W> {
        // Some readers refuse a group without rows.
        if self.columns.iter().any(|column| !column.is_empty()) {
            self.write().map_err(of_writer)?;
        }
        self.writer.finish().map_err(of_writer)?;
        self.writer.inner_mut().0.take().ok_or_else(Held::<W>::lost)
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

/// A writer that can be taken back after the last byte: where the library returns the writer itself, it turns an error of
/// the writer into a text.
struct Held<W>(Option<W>);

impl<W> Held<W> {
    fn writer(&mut self) -> io::Result<&mut W> {
        self.0.as_mut().ok_or_else(Self::lost)
    }

    fn lost() -> io::Error {
        io::Error::other("the table has ended")
    }
}

impl<W: Write> Write for Held<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer()?.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer()?.flush()
    }
}

/// The error of the writer where the library only passes it on, so that callers know a reader that has gone.
fn of_writer(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(source) => match source.downcast() {
            Ok(error) => *error,
            Err(source) => io::Error::other(source),
        },
        error => error.into(),
    }
}
