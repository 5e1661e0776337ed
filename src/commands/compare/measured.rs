//! A suspension beside a table of measured numbers.

mod columns;
mod heading;
mod places;
mod quantity;

use std::path::Path;
use std::sync::atomic::AtomicBool;

use crate::commands::compare::differences::{Difference, Part};
use crate::commands::compare::report::Report;
use crate::commands::compare::short_name::short_names;
use crate::failure::Failure;
use crate::file::Source;
use crate::load::load;
use crate::measured_table::MeasuredTable;
use crate::mechanism::{Description, ends, evenly_spaced};
use crate::number::counted;
use crate::quantities::Column;
use columns::Known;
use places::Places;
use quantity::Quantity;

/// Returns whether a file is a table, by the end of its name.
pub(super) fn is_table(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    ["csv", "tsv", "txt"].iter().any(|table| ending == *table)
}

/// Compares a suspension with a table, in which drives have changes or, if `absolute`, their own values.
///
/// # Errors
///
/// [`Failure::Input`] at a heading, at a field without a number, and at a place out of reach.
pub(super) fn compare(
    [model, measured]: [&Source; 2],
    absolute: bool,
    interrupted: &AtomicBool,
) -> Result<Report, Failure> {
    let loaded = load(model)?;
    let mechanism = &*loaded.at_design()?;
    let mut table = MeasuredTable::new(measured)?;
    let mut known = Known::all(&mut table, mechanism, absolute)?;
    let place = known.remove(place_column(&table, mechanism, &known)?);
    let (held, known): (Vec<Known>, Vec<Known>) = known.into_iter().partition(Known::is_drive);
    let places = Places {
        file: model.name(),
        mechanism,
        stated: place.stated,
        held: held.iter().map(Known::held).collect(),
        interrupted,
    };
    let at = (place.column, &*place.numbers);
    let quantities = quantities(&table, &places, at, known)?;
    let files = [model, measured].map(|file| file.name().to_owned());
    let names = short_names([&files[0], &files[1]]);
    let charts = quantities.iter();
    let charts = charts.map(|quantity| quantity.chart(&names, places.label()));
    Ok(Report {
        title: "A suspension and measurements compared",
        legend: [
            format!("{} ({})", files[0], mechanism.linkage),
            format!(
                "{} ({})",
                files[1],
                counted(table.lines(), "measured place")
            ),
        ],
        files,
        notes: quantities.iter().filter_map(Quantity::unknown).collect(),
        missing: Vec::new(),
        parts: parts(&quantities, &places.label()),
        charts: vec![(
            format!("Over {}", places.stated.named.title),
            charts.collect(),
        )],
    })
}

/// Compares the numbers as they are measured, and without the offset of each quantity.
fn parts(quantities: &[Quantity], across: &str) -> Vec<Part> {
    let part = |of: &str, heading: &str, difference: fn(&Quantity) -> Option<Difference>| Part {
        of: of.to_owned(),
        heading: format!("{heading}, at a {across}"),
        across: Some(across.to_owned()),
        differences: quantities.iter().filter_map(difference).collect(),
    };
    let at_design = "Offset: the difference at the measured place nearest to the design position";
    vec![
        part(
            "as measured",
            "Largest difference as measured",
            Quantity::largest,
        ),
        part("offset", at_design, Quantity::offset),
        part(
            "without offset",
            "Largest difference without offset",
            Quantity::largest_without_offset,
        ),
    ]
}

/// Finds the column that says where the model is: that of a drive, or else that of wheel travel or of the steering wheel's
/// angle. Drives that do not change are held.
fn place_column(
    table: &MeasuredTable,
    mechanism: &Description,
    known: &[Known],
) -> Result<usize, Failure> {
    let columns = |is_place: &dyn Fn(&Known) -> bool| -> Vec<usize> {
        let all = 0..known.len();
        all.filter(|index| is_place(&known[*index])).collect()
    };
    let found = [
        columns(&|known| known.is_drive() && known.changes()),
        columns(&|known| known.leads() && known.changes()),
        columns(&Known::is_drive),
        columns(&Known::leads),
    ];
    let found = found.into_iter().find(|columns| !columns.is_empty());
    match found.unwrap_or_default()[..] {
        [place, other, ..] if known[place].changes() => {
            let [one, other] = [place, other].map(|place| &known[place]);
            let drive =
                |known: &Known| &mechanism.names.drives[known.stated.named.drives[0].0].name;
            let message = format!(
                "`{}` and `{}` both say where the model is, and one column must; empty the heading of one or, where drives move alike, \
                 name them in one heading, as `{},{} [{}]`",
                one.stated.named.title,
                other.stated.named.title,
                drive(one),
                drive(other),
                one.stated.symbol
            );
            Err(table.refuse_heading(other.column, message))
        }
        [place, ..] => Ok(place),
        [] => {
            let names = mechanism.names.drive_names().join(", ");
            let message = format!(
                "no column says where the model is; head one with a drive and its unit (the drives are {names}), with wheel travel, for \
                 which [vehicle] may have to state travel = \"DRIVE\", or with steering_wheel_angle, for which it states rack_per_turn. \
                 The headings are the first line that does not begin with #"
            );
            Err(table.refuse_heading(0, message))
        }
    }
}

/// Reads the quantities of a table, and those of the model at the places of a column.
fn quantities(
    table: &MeasuredTable,
    places: &Places<'_>,
    (column, at): (usize, &[f64]),
    known: Vec<Known>,
) -> Result<Vec<Quantity>, Failure> {
    /// The number of places along the model's curves.
    const ALONG: usize = 61;
    // Wheel travel may lack a number where it does not say where the model is.
    table.numbers(column)?;
    let Some(range) = ends(at.iter().copied()).filter(|_| !known.is_empty()) else {
        let message = "the table needs a column of a quantity beside this one, as `toe [deg]`, and lines of numbers; suspension \
                       sweep writes a table with the names of all";
        return Err(table.refuse_heading(column, message));
    };
    let columns = known.iter();
    let columns = columns.filter_map(|known| known.stated.named.quantity.as_ref());
    let columns: Vec<&Column> = columns.collect();
    let model = places.read(at, &columns)?;
    if let Some(line) = model.iter().position(Option::is_none) {
        let reached = at.iter().zip(&model).filter(|(_, model)| model.is_some());
        let message = places.out_of_reach(at[line], ends(reached.map(|(at, _)| *at)));
        return Err(table.refuse_number(line, column, message));
    }
    let along = evenly_spaced(range, ALONG);
    let curves = places.read(&along, &columns)?;
    let quantity = |(
        index,
        Known {
            stated, numbers, ..
        },
    ): (usize, Known)| {
        let of_model = |read: &Option<Vec<f64>>| {
            let number = read.as_ref().map_or(f64::NAN, |numbers| numbers[index]);
            number * stated.scale
        };
        let pairs = model.iter().map(of_model).zip(numbers);
        let pairs = at.iter().copied().zip(pairs.map(<[f64; 2]>::from));
        let curve = along.iter().copied().zip(curves.iter().map(of_model));
        Quantity {
            places: pairs
                .filter(|(_, [model, measured])| (model - measured).is_finite())
                .collect(),
            curve: curve.collect(),
            title: stated.named.title,
            symbol: stated.symbol,
        }
    };
    Ok(known.into_iter().enumerate().map(quantity).collect())
}
