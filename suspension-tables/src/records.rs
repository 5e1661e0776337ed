//! Records of texts and numbers, as comma-separated values and JSON.

use serde::Serialize;

use crate::csv_file::{CsvFile, format_in_full};
use crate::heading::Heading;
use crate::json_file::JsonFile;
use crate::rows::Forms;
use suspension_mechanism::failure::Failure;

/// A field of a record.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum Field {
    /// A text.
    Text(String),
    /// A number; a missing one is empty in comma-separated values and null in JSON.
    Number(Option<f64>),
}

impl Field {
    fn into_text(self) -> String {
        match self {
            Self::Text(text) => text,
            Self::Number(number) => number.map_or_else(String::new, format_in_full),
        }
    }
}

/// Writes records with these names of their fields; JSON has a header before them.
///
/// # Errors
///
/// See [`Failure::writing`].
pub fn write(
    forms: &Forms,
    header: &impl Serialize,
    names: &[&str],
    records: &[Vec<Field>],
) -> Result<(), Failure> {
    let headings: Vec<Heading> = names.iter().map(|name| Heading::new(*name)).collect();
    if let Some(target) = &forms.csv {
        let mut file = CsvFile::create(target, &headings)?;
        for record in records {
            let texts = record.iter().cloned().map(Field::into_text);
            let texts: Vec<String> = texts.collect();
            file.record(texts.iter().map(String::as_str))?;
        }
        file.finish()?;
    }
    if let Some(target) = &forms.json {
        let mut file = JsonFile::create(target, header, &headings)?;
        for record in records {
            file.row(record)?;
        }
        file.finish()?;
    }
    Ok(())
}
