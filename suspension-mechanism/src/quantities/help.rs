//! The catalogue in words, for help.

use std::fmt::Write;

use crate::mechanism::{Names, Unit};
use crate::quantities::quantity::{Quantity, columns};

/// Descriptions of quantities, each under the names of its first and last column for a linkage; those that it lacks
/// are left out.
pub fn in_words(
    quantities: impl IntoIterator<Item = &'static Quantity>,
    names: &Names,
    unit: Unit,
) -> String {
    let mut text = String::new();
    for quantity in quantities {
        let columns = columns([quantity], names);
        let (Some(first), Some(last)) = (columns.first(), columns.last()) else {
            continue;
        };
        let name = match columns.len() {
            1 => first.csv_name(unit),
            _ => format!("{} to {}", first.csv_name(unit), last.csv_name(unit)),
        };
        entry(&mut text, quantity, &name, &first.dimension.symbol(unit));
    }
    text
}

/// The most characters of a line of text, which a terminal does not break.
pub const WIDTH: usize = 120;

/// The indent of all lines but the first.
const INDENT: &str = "      ";

/// A name and what it names, followed by the definition, and then by sign and source.
fn entry(text: &mut String, quantity: &Quantity, name: &str, symbol: &str) {
    let Quantity {
        title,
        sign,
        definition,
        source,
        ..
    } = quantity;
    let unit = if symbol.is_empty() { "" } else { ", " };
    let sign = if sign.is_empty() {
        String::new()
    } else {
        format!("; {sign}")
    };
    let first = format!("{name:<22} {title}{unit}{symbol}{sign}");
    let source = format!("({source})");
    for (indent, paragraph) in [
        ("  ", first.as_str()),
        (INDENT, definition),
        (INDENT, &source),
    ] {
        let lines = textwrap::Options::new(WIDTH)
            .initial_indent(indent)
            .subsequent_indent(INDENT);
        let _ = writeln!(text, "{}", textwrap::fill(paragraph, lines));
    }
}
