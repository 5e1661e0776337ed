//! Records of texts and numbers, as comma-separated values and JSON.

use serde::{Serialize, Serializer};

use crate::csv_file::{CsvFile, format_in_full};
use crate::files::unless_reader_gone;
use crate::heading::Heading;
use crate::json_file::JsonFile;
use crate::rows::TableTargets;
use crate::target::Target;
use suspension_mechanism::failure::Failure;
use suspension_mechanism::number::unsigned_zero;

/// A field of a record.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum Field {
    /// A text.
    Text(String),
    /// A number; a missing one is empty in comma-separated values and null in JSON. Zero has no sign.
    Number(#[serde(serialize_with = "unsigned")] Option<f64>),
}

fn unsigned<S: Serializer>(number: &Option<f64>, serializer: S) -> Result<S::Ok, S::Error> {
    number.map(unsigned_zero).serialize(serializer)
}

impl Field {
    fn into_text(self) -> String {
        match self {
            Self::Text(text) => text,
            Self::Number(number) => number.map_or_else(String::new, format_in_full),
        }
    }
}

/// Writes records with these names of their fields; JSON has a header before them. A table whose reader has gone is left out.
///
/// # Errors
///
/// See [`Failure::writing`].
pub fn write(
    tables: &TableTargets,
    header: &impl Serialize,
    names: &[&str],
    records: &[Vec<Field>],
) -> Result<(), Failure> {
    let headings: Vec<Heading> = names.iter().map(|name| Heading::new(*name)).collect();
    if let Some(target) = &tables.csv {
        unless_reader_gone(write_csv(target, &headings, records))?;
    }
    if let Some(target) = &tables.json {
        unless_reader_gone(write_json(target, header, &headings, records))?;
    }
    Ok(())
}

fn write_csv(target: &Target, headings: &[Heading], records: &[Vec<Field>]) -> Result<(), Failure> {
    let mut file = CsvFile::create(target, headings)?;
    for record in records {
        let texts = record.iter().cloned().map(Field::into_text);
        let texts: Vec<String> = texts.collect();
        file.record(texts.iter().map(String::as_str))?;
    }
    file.finish()
}

fn write_json(
    target: &Target,
    header: &impl Serialize,
    headings: &[Heading],
    records: &[Vec<Field>],
) -> Result<(), Failure> {
    let mut file = JsonFile::create(target, header, headings)?;
    for record in records {
        file.row(record)?;
    }
    file.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_has_no_sign_and_a_missing_number_no_text() {
        let [zero, none] = [Some(-0.0), None].map(Field::Number);
        let json = [&zero, &none].map(|field| serde_json::to_string(field).expect("JSON"));
        assert_eq!(json, ["0.0", "null"]);
        assert_eq!([zero, none].map(Field::into_text), ["0.0", ""]);
    }
}
