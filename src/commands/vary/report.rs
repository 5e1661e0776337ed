//! The numbers of a study as text, comma-separated values and JSON.

use serde::Serialize;

use crate::characteristics::DesignNumber;
use crate::commands::vary::study::{Study, Variant};
use crate::commands::vary::varied::{Varied, label};
use crate::failure::Failure;
use crate::output::page::in_digits;
use crate::output::records::{self, Field};
use crate::output::rows::Forms;
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
    /// Returns a table with a row for each number and a column for each value.
    pub(super) fn text(&self) -> String {
        let titles = self.numbers.iter();
        let titles = titles.map(|number| match number.symbol.as_str() {
            "" => number.title.clone(),
            symbol => format!("{} ({symbol})", number.title),
        });
        let first = TextColumn::left(titles).headed("quantity");
        let of_variant = |variant: &Variant| {
            let numbers = self.numbers.iter();
            let cells = numbers.map(|number| in_digits(variant.shown(number)));
            TextColumn::right(cells).headed(heading(variant))
        };
        let columns = self.study.variants.iter().map(of_variant);
        let table = in_parts(2, WIDTH, &first, columns.collect());
        format!("{}\n\n{table}", self.heading())
    }

    /// Says what is varied.
    pub(super) fn heading(&self) -> String {
        let Varied {
            file,
            mechanism,
            change,
        } = self.varied;
        let (unit, axes) = (mechanism.unit.symbol(), mechanism.axes.in_words());
        format!(
            "{file}: change of {} from the design, in {unit}; axes of {axes}",
            change.name
        )
    }

    /// Writes a record for each number at each value.
    pub(super) fn write(&self, forms: &Forms) -> Result<(), Failure> {
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
        records::write(forms, &header, &NAMES, &records)
    }
}

/// Returns the heading of a variant's column.
fn heading(variant: &Variant) -> String {
    match variant.value {
        0.0 => DESIGN.to_owned(),
        value => label(value),
    }
}
