//! The comparison as text and as comma-separated values.

use std::fmt::Write;

use crate::characteristics::{Curves, Does, Line, Parameter};
use crate::commands::compare::differences::{
    ALIKE, Comparison, Difference, Part, pairs, same_ways, unmatched,
};
use crate::commands::compare::side::Side;
use crate::failure::Failure;
use crate::file::Dimension;
use crate::output::csv_file::{CsvFile, in_full};
use crate::output::heading::Heading;
use crate::output::page::in_digits;
use crate::output::target::Target;
use crate::output::text_table::{TextColumn, laid_out};
use crate::quantities::{Axis, CENTRE, WHEEL_TRAVEL};

/// Which file is which, a line each.
pub(super) fn legend(sides: [&Side; 2]) -> [String; 2] {
    sides.map(|side| {
        let converted = side.converted.as_ref();
        let converted = converted.map_or_else(String::new, |how| format!(", converted {how}"));
        format!("{} ({}{converted})", side.file, side.linkage)
    })
}

/// Above a part.
pub(super) fn heading(part: &Part) -> String {
    match (part.of.as_str(), &part.across) {
        (of, Some(across)) => format!("Largest difference {of}, at a {across}"),
        ("design", None) => "At the design position".to_owned(),
        (of, None) => format!("At the design position, {of}"),
    }
}

/// The comparison for people.
pub(super) fn text(sides: [&Side; 2], comparison: &Comparison) -> String {
    let [a, b] = legend(sides);
    let mut out = format!("A  {a}\nB  {b}\n");
    for note in notes(sides) {
        // Writing into a string has no way to fail.
        let _ = writeln!(out, "{note}");
    }
    for part in &comparison.parts {
        let (heading, table) = (heading(part), laid_out(2, columns(part)));
        let _ = write!(out, "\n{heading}\n\n{table}");
    }
    out
}

/// What of the drives cannot be compared, a sentence each.
pub(super) fn notes(sides: [&Side; 2]) -> Vec<String> {
    let unlike = same_ways(sides)
        .into_iter()
        .filter(|[a, b]| a.dimension != b.dimension);
    let unlike = unlike.map(|[a, b]| {
        let what = |curves: &Curves| match curves.dimension == Dimension::Angle {
            true => "an angle",
            false => "a length",
        };
        format!(
            "`{}` of A is {}, `{}` of B {}: no curves along them are compared",
            a.title,
            what(a),
            b.title,
            what(b)
        )
    });
    let unlike_travel = same_ways(sides).into_iter().filter_map(unlike_travel);
    let [a, b] = sides;
    let across = across(sides);
    let alone = |side, other, name| {
        let curves = unmatched(side, other).into_iter();
        curves.map(move |Curves { title, .. }| {
            format!("{name} has nothing like `{title}`: no curves over it are compared")
        })
    };
    let alone = alone(a, b, "B").chain(alone(b, a, "A"));
    let notes = unlike.chain(unlike_travel).chain(alone);
    notes.chain(across).collect()
}

/// Says so where a wheel on the left is compared with one on the right.
fn across(sides: [&Side; 2]) -> Option<String> {
    let side = |side: &Side| {
        let mut centres = side.parameters.iter();
        let is_across = |parameter: &&Parameter| {
            parameter.title.wheel.is_none() && parameter.is(&CENTRE, Axis::Y)
        };
        let outwards = centres.find(is_across)?.value;
        (outwards != 0.0).then_some(outwards > 0.0)
    };
    let [a, b] = sides.map(side);
    (a? != b?).then(|| {
        "the wheels are on opposite sides of the vehicle: what is along y, and what steering does, has the other sign".to_owned()
    })
}

/// Says so where equal changes of two drives are not equal travels of the wheels.
fn unlike_travel([a, b]: [&Curves; 2]) -> Option<String> {
    let mut lines = pairs(a, b).into_iter();
    if a.way.does == Does::Steer {
        return None;
    }
    let [of_a, of_b] = lines.find(|[line, _]| line.title.of_wheel == WHEEL_TRAVEL.title)?;
    let [rise_a, rise_b] = [rise(a, of_a)?, rise(b, of_b)?];
    let is_unlike = a.dimension == b.dimension && (rise_b - rise_a).abs() > ALIKE * rise_a.abs();
    is_unlike.then(|| {
        let (rise_a, rise_b) = (in_digits(rise_a), in_digits(rise_b));
        format!(
            "on average over the curve the wheel rises by {rise_a} per unit of `{}` of A and by {rise_b} of `{}` of B: what is \
             compared over {} is at equal changes of the drives, not of the wheels",
            a.title, b.title, a.way
        )
    })
}

/// How far the wheel rises per change of the drive, over all of the curve.
fn rise(curves: &Curves, line: &Line) -> Option<f64> {
    let points = curves.points(line);
    let mut known = points.iter().filter(|(_, value)| value.is_finite());
    let (first, last) = (known.next()?, known.next_back()?);
    Some((last.1 - first.1) / (last.0 - first.0))
}

/// The differences; the last column, where the curves differ most, is of curves alone.
fn columns(part: &Part) -> Vec<TextColumn> {
    let differences = || part.differences.iter();
    let numbers = |title, value: &dyn Fn(&Difference) -> f64| {
        let cells = differences().map(|difference| in_digits(value(difference)));
        TextColumn::numbers(cells).under(title)
    };
    let quantities = differences().map(|difference| &difference.quantity);
    let symbols = differences().map(|difference| &difference.symbol);
    let mut columns = vec![
        TextColumn::left(quantities).under("quantity"),
        numbers("A", &|difference| difference.values[0]),
        numbers("B", &|difference| difference.values[1]),
        numbers("B - A", &Difference::value),
        TextColumn::left(symbols).under("unit"),
    ];
    if differences().any(|difference| difference.at.is_some()) {
        columns.push(numbers("at", &|difference| {
            difference.at.unwrap_or(f64::NAN)
        }));
    }
    columns
}

/// The comparison as comma-separated values.
pub(super) fn table(comparison: &Comparison, target: &Target) -> Result<(), Failure> {
    let names = ["of", "quantity", "unit", "at", "a", "b", "difference"];
    let headings = names.map(|name| Heading {
        name: name.to_owned(),
        counts: false,
    });
    let mut file = CsvFile::create(target, &headings)?;
    for part in &comparison.parts {
        for difference in &part.differences {
            let [a, b] = difference.values.map(in_full);
            let at = difference.at.map_or_else(String::new, in_full);
            let (quantity, symbol) = (&difference.quantity, &difference.symbol);
            let value = in_full(difference.value());
            file.record([part.of.as_str(), quantity, symbol, &at, &a, &b, &value].into_iter())?;
        }
    }
    file.finish()
}
