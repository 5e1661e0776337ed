//! Lines of numbers under headings.

use crate::number::fixed;
use crate::output::text_table::{TextColumn, laid_out};

/// Decimals of a force: a tenth of a newton.
const DECIMALS: usize = 1;

/// A named number with its unit: the value at one place, or the least and the greatest of several places.
pub(super) struct Line {
    pub(super) name: String,
    pub(super) numbers: Vec<f64>,
    pub(super) unit: &'static str,
    pub(super) places: [String; 2],
    /// The largest magnitude over all places.
    pub(super) largest: f64,
}

pub(super) fn shown(force: f64) -> String {
    fixed(force, DECIMALS)
}

/// Lays lines out under a heading, decimal points aligned, the least and the greatest with their places.
pub(super) fn table([what, heading]: [&str; 2], lines: &[Line]) -> String {
    let several = lines.first().is_some_and(|line| line.numbers.len() == 2);
    let between = if several { " to " } else { "  " };
    let column = |number: usize| {
        let numbers = lines.iter().map(|line| shown(line.numbers[number]));
        TextColumn::numbers(numbers)
    };
    let numbers = 0..lines.first().map_or(0, |line| line.numbers.len());
    let numbers = numbers.map(column);
    let Some(numbers) = numbers.reduce(|column, next| column.joined(between, next)) else {
        return String::new();
    };
    let names = TextColumn::left(lines.iter().map(|line| &line.name));
    let units = TextColumn::left(lines.iter().map(|line| line.unit));
    let numbers = numbers.joined(" ", units).headed(heading);
    let mut columns = vec![names.headed(what), numbers];
    if lines
        .iter()
        .any(|line| line.places != [const { String::new() }; 2])
    {
        let places = |end: usize| TextColumn::left(lines.iter().map(move |line| &line.places[end]));
        columns.push(places(0).headed("least at"));
        columns.push(places(1).headed("greatest at"));
    }
    laid_out(0, columns) + "\n"
}
