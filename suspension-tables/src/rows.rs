//! Rows of numbers, written in one format or in several.

use std::path::PathBuf;

use crate::csv_file::CsvFile;
use crate::files::{refuse_input, unless_reader_gone};
use crate::heading::{Header, Heading};
use crate::json_file::JsonFile;
use crate::parquet_file::{self, ParquetFile};
use crate::target::Target;
use suspension_mechanism::failure::Failure;
use suspension_mechanism::number::unsigned_zero;

/// The destinations of rows by format.
#[derive(Clone, Debug, Default)]
pub struct TableTargets {
    /// The destination of comma-separated values.
    pub csv: Option<Target>,
    /// The destination of JSON.
    pub json: Option<Target>,
    /// The destination of Parquet, which needs a feature of the package.
    pub parquet: Option<Target>,
}

impl TableTargets {
    /// Returns whether there is no destination.
    pub fn is_empty(&self) -> bool {
        self.csv.is_none() && self.json.is_none() && self.parquet.is_none()
    }

    /// Returns whether a table goes to standard output, where no report may then go.
    pub fn is_to_stdout(&self) -> bool {
        let mut targets = self.targets().into_iter();
        targets.any(|(target, _)| *target == Some(Target::Stdout))
    }

    /// Refuses to overwrite a file that was read, two formats at one place, and a format that the program is built without.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`].
    pub fn check(&self) -> Result<(), Failure> {
        for (path, option) in self.files() {
            refuse_input(path, option)?;
        }
        if self.parquet.is_some() {
            parquet_file::available()?;
        }
        let all = self.targets();
        for (index, (target, option)) in all.iter().enumerate() {
            for (other, before) in &all[..index] {
                if let (Some(target), Some(other)) = (target, other) {
                    other.refuse_same(target, [before, option])?;
                }
            }
        }
        Ok(())
    }

    /// The same for these destinations and another one, which an option names.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`].
    pub fn check_with(&self, another: Option<&Target>, option: &str) -> Result<(), Failure> {
        self.check()?;
        let Some(another) = another else {
            return Ok(());
        };
        another.refuse_input(option)?;
        for (target, of_table) in self.targets() {
            if let Some(target) = target {
                another.refuse_same(target, [option, of_table])?;
            }
        }
        Ok(())
    }

    /// Returns the files with the options that name them.
    pub fn files(&self) -> impl Iterator<Item = (&PathBuf, &'static str)> {
        self.targets()
            .into_iter()
            .filter_map(|(target, option)| match target {
                Some(Target::File(path)) => Some((path, option)),
                _ => None,
            })
    }

    /// Returns the destinations with the options that name them.
    fn targets(&self) -> [(&Option<Target>, &'static str); 3] {
        [
            (&self.csv, "--csv"),
            (&self.json, "--json"),
            (&self.parquet, "--parquet"),
        ]
    }
}

/// Rows that are being written.
pub struct Rows {
    csv: Option<CsvFile>,
    json: Option<JsonFile>,
    parquet: Option<ParquetFile>,
    /// The row that is being written.
    row: Vec<f64>,
}

impl Rows {
    /// Starts the files with their headers.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn create(
        tables: &TableTargets,
        header: &Header,
        headings: &[Heading],
    ) -> Result<Self, Failure> {
        let TableTargets { csv, json, parquet } = tables;
        let csv = csv.as_ref().map(|target| CsvFile::create(target, headings));
        let json = json.as_ref();
        let json = json.map(|target| JsonFile::create(target, header, headings));
        let parquet = parquet.as_ref();
        let parquet = parquet.map(|target| ParquetFile::create(target, header, headings));
        Ok(Self {
            csv: csv.transpose()?,
            json: json.transpose()?,
            parquet: parquet.transpose()?,
            row: Vec::new(),
        })
    }

    /// Adds a row; zeros have no sign. A table whose reader has gone is left out from then on.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`]; [`Failure::ReaderGone`] if no table is left.
    pub fn add(&mut self, values: &[f64]) -> Result<(), Failure> {
        self.row.clear();
        self.row.extend(values.iter().copied().map(unsigned_zero));
        let row = &self.row;
        let gone = [
            has_gone(&mut self.csv, |csv| csv.row(row))?,
            has_gone(&mut self.json, |json| json.row(row))?,
            has_gone(&mut self.parquet, |parquet| parquet.row(row))?,
        ];
        let is_left = self.csv.is_some() || self.json.is_some() || self.parquet.is_some();
        if gone.contains(&true) && !is_left {
            return Err(Failure::ReaderGone);
        }
        Ok(())
    }

    /// Ends the tables; files get their names.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn finish(self) -> Result<(), Failure> {
        unless_reader_gone(self.csv.map_or(Ok(()), CsvFile::finish))?;
        unless_reader_gone(self.json.map_or(Ok(()), JsonFile::finish))?;
        unless_reader_gone(self.parquet.map_or(Ok(()), ParquetFile::finish))
    }
}

/// Writes to a table. If its reader has gone, leaves it out and says so.
fn has_gone<T>(
    table: &mut Option<T>,
    write: impl FnOnce(&mut T) -> Result<(), Failure>,
) -> Result<bool, Failure> {
    match table.as_mut().map_or(Ok(()), write) {
        Err(Failure::ReaderGone) => {
            *table = None;
            Ok(true)
        }
        written => written.map(|()| false),
    }
}
