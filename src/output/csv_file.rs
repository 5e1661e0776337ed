//! Rows as comma-separated values, each with as many digits as it takes to read the same number.

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

impl From<PathBuf> for Target {
    /// Standard output for `-`, else a file.
    fn from(path: PathBuf) -> Self {
        if path.as_os_str() == "-" {
            Self::Stdout
        } else {
            Self::File(path)
        }
    }
}

/// A column: what stands above it, and how its numbers are written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Heading {
    /// The column's name.
    pub name: String,
    /// Whether its numbers are counts, written without a fraction.
    pub counts: bool,
}

/// A table of comma-separated values being written.
pub struct CsvFile {
    name: String,
    writer: csv::Writer<Sink>,
    counts: Vec<bool>,
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
    pub fn create(target: &Target, headings: &[&Heading]) -> Result<Self, Failure> {
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
    pub fn row(&mut self, values: &[f64]) -> Result<(), Failure> {
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
        match sink.map_err(|error| Failure::writing(&self.name, error.error()))? {
            Sink::Stdout(mut out) => out
                .flush()
                .map_err(|error| Failure::writing(&self.name, &error)),
            Sink::File(file) => file.finish(),
        }
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

fn file(path: &Path) -> Result<Sink, Failure> {
    Pending::create(path).map(Sink::File)
}
