//! Rows as comma-separated values, each with the digits needed to read back the same number.

use std::io::Write;

use crate::heading::Heading;
use crate::target::{Sink, Target};
use suspension_mechanism::failure::Failure;
use suspension_mechanism::number::unsigned_zero;

/// The number of bytes that are collected before they are written.
const GATHERED: usize = 1 << 16;

/// Formats a number with the digits needed to read back the same number; zero has no sign.
pub(crate) fn format_in_full(value: f64) -> String {
    zmij::Buffer::new().format(unsigned_zero(value)).to_owned()
}

/// A table of comma-separated values that is being written.
pub(crate) struct CsvFile {
    sink: Sink,
    counts: Vec<bool>,
    /// Rows that are not written yet.
    text: Vec<u8>,
}

impl CsvFile {
    /// Starts a table with its header.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub(crate) fn create(target: &Target, headings: &[Heading]) -> Result<Self, Failure> {
        let mut table = Self {
            sink: Sink::create(target)?,
            counts: headings.iter().map(|heading| heading.counts).collect(),
            text: Vec::with_capacity(GATHERED),
        };
        table.record(headings.iter().map(|heading| heading.name.as_str()))?;
        Ok(table)
    }

    /// Adds a row. Numbers need no quotes.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub(crate) fn row(&mut self, values: &[f64]) -> Result<(), Failure> {
        let mut buffer = zmij::Buffer::new();
        for (value, counts) in values.iter().zip(&self.counts) {
            if *counts {
                self.text.extend_from_slice(value.to_string().as_bytes());
            } else {
                let number = buffer.format(*value);
                self.text.extend_from_slice(number.as_bytes());
            }
            self.text.push(b',');
        }
        self.text.pop();
        self.text.push(b'\n');
        self.write(GATHERED)
    }

    /// Ends the table; the file gets its name.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub(crate) fn finish(mut self) -> Result<(), Failure> {
        self.write(0)?;
        self.sink.finish()
    }

    /// Adds a row of texts.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub(crate) fn record<'a>(
        &mut self,
        fields: impl Iterator<Item = &'a str>,
    ) -> Result<(), Failure> {
        let mut writer = csv::Writer::from_writer(&mut self.text);
        let quoted = writer.write_record(fields);
        let quoted = quoted.and_then(|()| Ok(writer.flush()?));
        drop(writer);
        match quoted {
            Ok(()) => self.write(GATHERED),
            Err(error) => Err(Failure::Output(format!(
                "{}: cannot be written: {error}",
                self.sink.name
            ))),
        }
    }

    /// Writes the collected rows if they have at least `least` bytes.
    fn write(&mut self, least: usize) -> Result<(), Failure> {
        if self.text.len() < least {
            return Ok(());
        }
        let written = self.sink.write_all(&self.text);
        self.text.clear();
        written.map_err(|error| Failure::writing(&self.sink.name, &error))
    }
}
