//! Rows as Parquet: one column per quantity, with units and axes as metadata.

use suspension_parquet::Table;

use crate::heading::{Header, Heading};
use crate::target::{Sink, Target};
use suspension_mechanism::failure::Failure;

/// Accepts Parquet, which this build can write.
///
/// # Errors
///
/// None.
#[expect(clippy::unnecessary_wraps, reason = "built without it, it cannot")]
pub(crate) fn available() -> Result<(), Failure> {
    Ok(())
}

/// A table as Parquet that is being written.
pub(crate) struct ParquetFile {
    name: String,
    table: Table<Sink>,
}

impl ParquetFile {
    /// Starts a table.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub(crate) fn create(
        target: &Target,
        header: &Header,
        headings: &[Heading],
    ) -> Result<Self, Failure> {
        let sink = Sink::create(target)?;
        let name = sink.name.clone();
        let columns = headings.iter().map(|heading| heading.name.as_str());
        match Table::create(sink, columns, header.entries()) {
            Ok(table) => Ok(Self { name, table }),
            Err(error) => Err(Failure::writing(&name, &error)),
        }
    }

    /// Adds a row.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub(crate) fn row(&mut self, values: &[f64]) -> Result<(), Failure> {
        let added = self.table.row(values);
        added.map_err(|error| Failure::writing(&self.name, &error))
    }

    /// Ends the table; a file takes its name.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub(crate) fn finish(self) -> Result<(), Failure> {
        let Self { name, table } = self;
        let finished = table.finish();
        let sink = finished.map_err(|error| Failure::writing(&name, &error))?;
        sink.finish()
    }
}
