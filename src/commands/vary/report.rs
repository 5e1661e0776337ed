//! The numbers of a study as text, comma-separated values and JSON.

use serde::Serialize;

use crate::characteristics::{DesignNumber, counted_downwards};
use crate::commands::vary::study::{Study, Variant};
use crate::commands::vary::varied::{Varied, label};
use crate::failure::Failure;
use crate::output::page::in_digits;
use crate::output::records::{self, Field};
use crate::output::rows::TableTargets;
use crate::output::text_table::{TextColumn, in_parts};
use crate::quantities::WIDTH;

/// The name of the design among values.
pub(super) const DESIGN: &str = "design";

/// A study with the numbers that are told of it.
pub(super) struct Report<'a> {
    pub(super) varied: &'a Varied<'a>,
    pub(super) study: &'a Study,
    pub(super) numbers: &'a [DesignNumber],
}

/// The header of JSON.
#[derive(Serialize)]
struct Header<'a> {
    file: &'a str,
    varied: &'a str,
    unit: &'a str,
    axes: &'a str,
}

impl Report<'_> {
    /// Returns a table with a row for each number and a column for each value; below it the names of numbers that are alike
    /// in all columns, unless they are asked for.
    pub(super) fn text(&self, shows_all: bool) -> String {
        let cells = |number: &DesignNumber| -> Vec<String> {
            let variants = self.study.variants.iter();
            variants
                .map(|variant| in_digits(variant.shown(number)))
                .collect()
        };
        let is_shown = |number: &&DesignNumber| {
            let cells = cells(number);
            shows_all || cells.len() == 1 || cells.iter().any(|cell| *cell != cells[0])
        };
        let (shown, alike): (Vec<_>, Vec<_>) = self.numbers.iter().partition(is_shown);
        let titles = shown.iter().map(|number| match number.symbol.as_str() {
            "" => number.title.clone(),
            symbol => format!("{} ({symbol})", number.title),
        });
        let first = TextColumn::left(titles).headed("quantity");
        let of_variant = |variant: &Variant| {
            let cells = shown.iter().map(|number| in_digits(variant.shown(number)));
            TextColumn::right(cells).headed(heading(variant))
        };
        let columns = self.study.variants.iter().map(of_variant);
        let table = in_parts(2, WIDTH, &first, columns.collect());
        let alike: Vec<String> = alike
            .into_iter()
            .map(|number| self.in_words(number))
            .collect();
        let alike = match alike[..] {
            [] => String::new(),
            _ => format!("\nAlike for all values: {}\n", alike.join(", ")),
        };
        format!("{}\n\n{table}{alike}", self.heading())
    }

    /// A number that all variants have, with its unit.
    fn in_words(&self, number: &DesignNumber) -> String {
        let variants = self.study.variants.first();
        let shown = variants.map_or(f64::NAN, |variant| variant.shown(number));
        let told = format!("{} {} {}", number.title, in_digits(shown), number.symbol);
        told.trim_end().to_owned()
    }

    /// Says what is varied.
    pub(super) fn heading(&self) -> String {
        let Varied {
            file,
            mechanism,
            change,
        } = self.varied;
        let (unit, axes) = (mechanism.unit.length.in_words(), mechanism.axes.in_words());
        let downwards = counted_downwards(*mechanism);
        let downwards = downwards.map_or_else(String::new, |note| format!(". {note}"));
        format!(
            "{file}: change of {} from the design, in {unit}; axes of {axes}{downwards}",
            change.name
        )
    }

    /// Writes a record for each number at each value.
    pub(super) fn write(&self, tables: &TableTargets) -> Result<(), Failure> {
        const NAMES: [&str; 5] = ["value", "of", "quantity", "unit", "number"];
        let of_variant = |variant: &Variant| -> Vec<Vec<Field>> {
            let record = |number: &DesignNumber| {
                let shown = Some(variant.shown(number)).filter(|shown| shown.is_finite());
                vec![
                    Field::Number(Some(variant.value)),
                    Field::Text(number.of.clone()),
                    Field::Text(number.quantity.clone()),
                    Field::Text(number.symbol.clone()),
                    Field::Number(shown),
                ]
            };
            self.numbers.iter().map(record).collect()
        };
        let records: Vec<Vec<Field>> = self.study.variants.iter().flat_map(of_variant).collect();
        let mechanism = self.varied.mechanism;
        let header = Header {
            file: self.varied.file,
            varied: &self.varied.change.name,
            unit: mechanism.unit.symbol(),
            axes: mechanism.axes.name(),
        };
        records::write(tables, &header, &NAMES, &records)
    }
}

/// Returns the heading of a variant's column.
fn heading(variant: &Variant) -> String {
    match variant.value {
        0.0 => DESIGN.to_owned(),
        value => label(value),
    }
}
