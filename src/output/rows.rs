//! Rows of numbers, written in one form or in several.

use std::path::{Path, PathBuf};

use crate::failure::Failure;
use crate::output::csv_file::CsvFile;
use crate::output::files::refuse_input;
use crate::output::heading::{Header, Heading};
use crate::output::json_file::JsonFile;
use crate::output::target::Target;

/// Where rows go, and in which form.
#[derive(Clone, Debug, Default)]
pub struct Forms {
    /// As comma-separated values.
    pub csv: Option<Target>,
    /// As JSON.
    pub json: Option<Target>,
}

impl Forms {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.csv.is_none() && self.json.is_none()
    }

    /// Refuses to write over the file that is read, and both forms to one place.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`].
    pub fn check(&self, input: &Path) -> Result<(), Failure> {
        for (path, option) in self.files() {
            refuse_input(path, input, option)?;
        }
        if self.csv.is_some() && self.csv == self.json {
            let message = "--csv and --json name the same place; give each its own";
            return Err(Failure::Input(message.to_owned()));
        }
        Ok(())
    }

    /// The files, each with the option that names it.
    pub fn files(&self) -> impl Iterator<Item = (&PathBuf, &'static str)> {
        let forms = [(&self.csv, "--csv"), (&self.json, "--json")];
        forms
            .into_iter()
            .filter_map(|(target, option)| match target {
                Some(Target::File(path)) => Some((path, option)),
                _ => None,
            })
    }
}

/// Rows being written.
pub struct Rows {
    csv: Option<CsvFile>,
    json: Option<JsonFile>,
}

impl Rows {
    /// Starts the files with their headers.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn create(forms: &Forms, header: &Header, headings: &[Heading]) -> Result<Self, Failure> {
        let Forms { csv, json } = forms;
        let csv = csv.as_ref().map(|target| CsvFile::create(target, headings));
        let json = json.as_ref();
        let json = json.map(|target| JsonFile::create(target, header, headings));
        Ok(Self {
            csv: csv.transpose()?,
            json: json.transpose()?,
        })
    }

    /// Starts comma-separated values alone.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn csv(target: &Target, headings: &[Heading]) -> Result<Self, Failure> {
        Ok(Self {
            csv: Some(CsvFile::create(target, headings)?),
            json: None,
        })
    }

    /// Adds a row.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn add(&mut self, values: &[f64]) -> Result<(), Failure> {
        if let Some(csv) = &mut self.csv {
            csv.row(values)?;
        }
        if let Some(json) = &mut self.json {
            json.row(values)?;
        }
        Ok(())
    }

    /// Ends them; files take their names.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn finish(self) -> Result<(), Failure> {
        self.csv.map_or(Ok(()), CsvFile::finish)?;
        self.json.map_or(Ok(()), JsonFile::finish)
    }
}
