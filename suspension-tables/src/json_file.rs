//! Rows as JSON: an object with a header, which states units and axes, and one object per row.

use std::io::{self, Write};

use serde::{Serialize, Serializer};

use crate::heading::Heading;
use crate::target::{Sink, Target};
use suspension_mechanism::failure::Failure;

/// A table as JSON that is being written.
pub(crate) struct JsonFile {
    sink: Sink,
    headings: Vec<Heading>,
    is_empty: bool,
}

/// The fields of a row with their names.
struct Row<'a, F>(&'a [Heading], &'a [F]);

impl<F: Serialize> Serialize for Row<'_, F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self(headings, values) = self;
        let names = headings.iter().map(|heading| &heading.name);
        serializer.collect_map(names.zip(values.iter()))
    }
}

impl JsonFile {
    /// Starts a table with its header.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub(crate) fn create(
        target: &Target,
        header: &impl Serialize,
        headings: &[Heading],
    ) -> Result<Self, Failure> {
        let mut file = Self {
            sink: Sink::create(target)?,
            headings: headings.to_vec(),
            is_empty: true,
        };
        file.write(|sink| {
            sink.write_all(b"{\"header\":")?;
            serde_json::to_writer(&mut *sink, header)?;
            sink.write_all(b",\n\"rows\":[")
        })?;
        Ok(file)
    }

    /// Adds a row; a number that is not finite becomes null.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub(crate) fn row(&mut self, values: &[impl Serialize]) -> Result<(), Failure> {
        let headings = std::mem::take(&mut self.headings);
        let separator: &[u8] = if self.is_empty { b"\n" } else { b",\n" };
        self.is_empty = false;
        let written = self.write(|sink| {
            sink.write_all(separator)?;
            Ok(serde_json::to_writer(sink, &Row(&headings, values))?)
        });
        self.headings = headings;
        written
    }

    /// Ends the table; the file gets its name.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub(crate) fn finish(mut self) -> Result<(), Failure> {
        self.write(|sink| sink.write_all(b"\n]}\n"))?;
        self.sink.finish()
    }

    fn write(&mut self, write: impl FnOnce(&mut Sink) -> io::Result<()>) -> Result<(), Failure> {
        write(&mut self.sink).map_err(|error| Failure::writing(&self.sink.name, &error))
    }
}
