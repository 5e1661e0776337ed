//! Rows as comma-separated values, 17 significant digits each.

use std::io::{self, BufWriter, Stdout, Write};
use std::path::{Path, PathBuf};

use crate::failure::Failure;
use crate::output::files::Pending;

/// Where comma-separated values go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// Standard output.
    Stdout,
    /// A file.
    File(PathBuf),
}

/// A table of comma-separated values being written.
pub struct CsvFile {
    name: String,
    writer: csv::Writer<Sink>,
    integer_columns: Vec<bool>,
}

enum Sink {
    Stdout(BufWriter<Stdout>),
    File(Pending),
}

impl Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Stdout(out) => out.write(bytes),
            Self::File(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Stdout(out) => out.flush(),
            Self::File(file) => file.flush(),
        }
    }
}

impl CsvFile {
    /// Starts a table with its header.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn create(target: &Target, columns: &[String]) -> Result<Self, Failure> {
        let (name, sink) = match target {
            Target::Stdout => {
                let out = BufWriter::new(io::stdout());
                ("standard output".to_owned(), Sink::Stdout(out))
            }
            Target::File(path) => (path.display().to_string(), file(path)?),
        };
        let mut table = Self {
            name,
            writer: csv::Writer::from_writer(sink),
            integer_columns: columns
                .iter()
                .map(|name| matches!(name.as_str(), "iterations" | "assembly" | "mirrored"))
                .collect(),
        };
        table.record(columns.iter().map(String::as_str))?;
        Ok(table)
    }

    /// Adds a row.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn row(&mut self, values: &[f64]) -> Result<(), Failure> {
        let values = values.iter().zip(&self.integer_columns);
        let fields: Vec<String> = values
            .map(|(value, integer)| {
                if *integer {
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
    pub fn finish(self) -> Result<(), Failure> {
        let sink = self.writer.into_inner();
        match sink.map_err(|error| Failure::writing(&self.name, error.error()))? {
            Sink::Stdout(mut out) => out
                .flush()
                .map_err(|error| Failure::writing(&self.name, &error)),
            Sink::File(file) => file.finish(),
        }
    }

    fn record<'a>(&mut self, fields: impl Iterator<Item = &'a str>) -> Result<(), Failure> {
        let written = self.writer.write_record(fields);
        written.map_err(|error| match error.into_kind() {
            csv::ErrorKind::Io(error) => Failure::writing(&self.name, &error),
            other => Failure::Output(format!("{}: cannot be written: {other:?}", self.name)),
        })
    }
}

fn file(path: &Path) -> Result<Sink, Failure> {
    Pending::create(path).map(Sink::File)
}
