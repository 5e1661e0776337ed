//! A comparison as text, comma-separated values and JSON.

use std::fmt::Write;

use serde::Serialize;

use crate::commands::compare::differences::{Difference, EVERYWHERE, Part};
use crate::failure::Failure;
use crate::output::page::in_digits;
use crate::output::plot::Chart;
use crate::output::records::{self, Field};
use crate::output::rows::TableTargets;
use crate::output::text_table::{TextColumn, laid_out};

/// What a comparison says, in whichever form.
pub(super) struct Report {
    pub(super) title: &'static str,
    /// The names of what is compared.
    pub(super) files: [String; 2],
    /// The same, described.
    pub(super) legend: [String; 2],
    /// Sentences on what cannot be compared, or not at equal changes.
    pub(super) notes: Vec<String>,
    /// Sentences on curves that are cut short.
    pub(super) missing: Vec<String>,
    pub(super) parts: Vec<Part>,
    /// Charts under their headings.
    pub(super) charts: Vec<(String, Vec<Chart>)>,
}

/// The header of JSON.
#[derive(Serialize)]
struct Header<'a> {
    a: &'a str,
    b: &'a str,
}

impl Report {
    pub(super) fn text(&self) -> String {
        let [a, b] = &self.legend;
        let mut out = format!("A  {a}\nB  {b}\n");
        for note in &self.notes {
            // Writing into a string cannot fail.
            let _ = writeln!(out, "{note}");
        }
        for part in &self.parts {
            let (heading, table) = (&part.heading, laid_out(2, columns(part)));
            let _ = write!(out, "\n{heading}\n\n{table}");
        }
        out
    }

    /// Writes a record for each difference.
    pub(super) fn write(&self, tables: &TableTargets) -> Result<(), Failure> {
        const NAMES: [&str; 9] = [
            "of",
            "quantity",
            "unit",
            "at",
            "a",
            "b",
            "difference",
            "rms",
            "along",
        ];
        let of_part = |part: &Part| -> Vec<Vec<Field>> {
            let across = part.across.clone().unwrap_or_default();
            let record = |difference: &Difference| {
                let [a, b] = difference.values;
                vec![
                    Field::Text(part.of.clone()),
                    Field::Text(difference.title.to_string()),
                    Field::Text(difference.symbol.clone()),
                    Field::Number(difference.at),
                    Field::Number(Some(a)),
                    Field::Number(Some(b)),
                    Field::Number(Some(difference.value())),
                    Field::Number(difference.rms),
                    Field::Text(across.clone()),
                ]
            };
            part.differences.iter().map(record).collect()
        };
        let records: Vec<Vec<Field>> = self.parts.iter().flat_map(of_part).collect();
        let [a, b] = &self.files;
        records::write(tables, &Header { a, b }, &NAMES, &records)
    }
}

/// Returns the columns of a table; those of the place of the largest difference and of the rms are for curves only.
fn columns(part: &Part) -> Vec<TextColumn> {
    let rows = part.rows();
    let differences = || rows.iter();
    let numbers = |title, value: &dyn Fn(&Difference) -> f64| {
        let cells = differences().map(|difference| in_digits(value(difference)));
        TextColumn::numbers(cells).headed(title)
    };
    let quantities = differences().map(|difference| &difference.title);
    let symbols = differences().map(|difference| &difference.symbol);
    let mut columns = vec![
        TextColumn::left(quantities).headed("quantity"),
        numbers("A", &|difference| difference.values[0]),
        numbers("B", &|difference| difference.values[1]),
        numbers("B - A", &Difference::value),
        TextColumn::left(symbols).headed("unit"),
    ];
    if part.across.is_some() {
        let at = |difference: &Difference| difference.at.map_or(EVERYWHERE.to_owned(), in_digits);
        columns.push(TextColumn::numbers(differences().map(at)).headed("at"));
    }
    if part.has_rms() {
        let rms = |difference: &Difference| difference.rms.map_or_else(String::new, in_digits);
        columns.push(TextColumn::numbers(differences().map(rms)).headed("rms"));
    }
    columns
}
