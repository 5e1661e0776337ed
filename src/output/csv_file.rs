//! Rows as comma-separated values, each with as many digits as it takes to read the same number.

use crate::failure::Failure;
use crate::output::heading::Heading;
use crate::output::target::{Sink, Target};

/// A table of comma-separated values being written.
pub struct CsvFile {
    name: String,
    writer: csv::Writer<Sink>,
    counts: Vec<bool>,
}

impl CsvFile {
    /// Starts a table with its header.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn create(target: &Target, headings: &[Heading]) -> Result<Self, Failure> {
        let sink = Sink::create(target)?;
        let name = sink.name.clone();
        let mut table = Self {
            name,
            writer: csv::Writer::from_writer(sink),
            counts: headings.iter().map(|heading| heading.counts).collect(),
        };
        table.record(headings.iter().map(|heading| heading.name.as_str()))?;
        Ok(table)
    }

    /// Adds a row.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub(super) fn row(&mut self, values: &[f64]) -> Result<(), Failure> {
        let mut buffer = zmij::Buffer::new();
        for (value, counts) in values.iter().zip(&self.counts) {
            let written = if *counts {
                self.writer.write_field(value.to_string())
            } else {
                self.writer.write_field(buffer.format(*value))
            };
            written.map_err(|error| failed(&self.name, error))?;
        }
        // Without a field: the end of the row.
        self.record(std::iter::empty())
    }

    /// Ends the table; a file takes its name.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn finish(self) -> Result<(), Failure> {
        let sink = self.writer.into_inner();
        let sink = sink.map_err(|error| Failure::writing(&self.name, error.error()))?;
        sink.finish()
    }

    /// Adds a row of texts.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn record<'a>(&mut self, fields: impl Iterator<Item = &'a str>) -> Result<(), Failure> {
        let written = self.writer.write_record(fields);
        written.map_err(|error| failed(&self.name, error))
    }
}

fn failed(name: &str, error: csv::Error) -> Failure {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => Failure::writing(name, &error),
        other => Failure::Output(format!("{name}: cannot be written: {other:?}")),
    }
}
