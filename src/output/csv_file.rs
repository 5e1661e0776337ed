//! Rows as comma-separated values, 17 significant digits each.

use crate::failure::Failure;
use crate::output::heading::Heading;
use crate::output::target::{Sink, Target};

/// A table of comma-separated values being written.
pub(super) struct CsvFile {
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
    pub(super) fn create(target: &Target, headings: &[Heading]) -> Result<Self, Failure> {
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
        let values = values.iter().zip(&self.counts);
        let fields: Vec<String> = values
            .map(|(value, counts)| {
                if *counts {
                    format!("{value}")
                } else {
                    format!("{value:.16e}")
                }
            })
            .collect();
        self.record(fields.iter().map(String::as_str))
    }

    /// Ends the table; a file takes its name.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub(super) fn finish(self) -> Result<(), Failure> {
        let sink = self.writer.into_inner();
        let sink = sink.map_err(|error| Failure::writing(&self.name, error.error()))?;
        sink.finish()
    }

    fn record<'a>(&mut self, fields: impl Iterator<Item = &'a str>) -> Result<(), Failure> {
        let written = self.writer.write_record(fields);
        written.map_err(|error| match error.into_kind() {
            csv::ErrorKind::Io(error) => Failure::writing(&self.name, &error),
            other => Failure::Output(format!("{}: cannot be written: {other:?}", self.name)),
        })
    }
}
