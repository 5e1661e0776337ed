//! A suspension beside a table of measured numbers.

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
use crate::measured::MeasuredTable;
use crate::mechanism::{Description, ends, evenly_spaced};
use crate::number::counted;
use crate::quantities::Column;
use heading::Stated;
use places::Places;
use quantity::Quantity;

/// Returns whether a file is a table, by the end of its name.
pub(super) fn is_table(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    ["csv", "tsv", "txt"].iter().any(|table| ending == *table)
}

/// Compares a suspension with a table.
///
/// # Errors
///
/// [`Failure::Input`] at a heading, at a field without a number, and at a place out of reach.
pub(super) fn compare(
    [model, measured]: [&Source; 2],
    interrupted: &AtomicBool,
) -> Result<Report, Failure> {
    let loaded = load(model)?;
    let mechanism = &*loaded.at_design()?;
    let table = MeasuredTable::new(measured)?;
    let headings = table.headings().into_iter().enumerate();
    let stated = headings.filter(|(_, heading)| !heading.is_empty());
    let stated = stated.map(|(column, heading)| {
        let stated = Stated::read(mechanism, column, heading);
        stated.map_err(|message| table.refuse_heading(column, message))
    });
    let mut stated: Vec<Stated> = stated.collect::<Result<_, _>>()?;
    let place = stated.remove(place_column(&table, mechanism, &stated)?);
    let places = Places {
        file: model.name(),
        mechanism,
        stated: place,
        interrupted,
    };
    let quantities = quantities(&table, &places, stated)?;
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

/// Finds the column that says where the model is: that of drives, or else that of wheel travel.
fn place_column(
    table: &MeasuredTable,
    mechanism: &Description,
    stated: &[Stated],
) -> Result<usize, Failure> {
    let columns = |is_place: fn(&Stated) -> bool| -> Vec<usize> {
        let all = 0..stated.len();
        all.filter(|index| is_place(&stated[*index])).collect()
    };
    let found = [
        columns(|stated| stated.named.quantity.is_none()),
        columns(|stated| !stated.named.drives.is_empty()),
    ];
    let found = found.into_iter().find(|columns| !columns.is_empty());
    match found.unwrap_or_default()[..] {
        [place] => Ok(place),
        [one, other, ..] => {
            let [one, other] = [one, other].map(|place| &stated[place]);
            let message = format!(
                "`{}` and `{}` both say where the model is, and one column must; empty the heading of the one that is held, or \
                 name drives that move together in one heading, as `left_bump,right_bump [mm]`",
                one.named.title, other.named.title
            );
            Err(table.refuse_heading(other.column, message))
        }
        [] => {
            let names = mechanism.names.drive_names().join(", ");
            let message = format!(
                "no column says where the model is; head one with a drive and its unit (the drives are {names}), or with wheel travel, \
                 for which [vehicle] may have to state travel = \"DRIVE\""
            );
            Err(table.refuse_heading(0, message))
        }
    }
}

/// Reads the quantities of a table, and those of the model at the same places.
fn quantities(
    table: &MeasuredTable,
    places: &Places<'_>,
    stated: Vec<Stated>,
) -> Result<Vec<Quantity>, Failure> {
    /// The number of places along the model's curves.
    const ALONG: usize = 61;
    let column = places.stated.column;
    let at = table.numbers(column)?;
    let Some(range) = ends(at.iter().copied()).filter(|_| !stated.is_empty()) else {
        let message =
            "the table needs a column of a quantity beside this one, and lines of numbers";
        return Err(table.refuse_heading(column, message));
    };
    let measured = stated.iter().map(|stated| table.numbers(stated.column));
    let measured: Vec<Vec<f64>> = measured.collect::<Result<_, _>>()?;
    let columns = stated
        .iter()
        .filter_map(|stated| stated.named.quantity.as_ref());
    let columns: Vec<&Column> = columns.collect();
    let model = places.read(&at, &columns)?;
    if let Some(line) = model.iter().position(Option::is_none) {
        let reached = at.iter().zip(&model).filter(|(_, model)| model.is_some());
        let message = places.out_of_reach(at[line], ends(reached.map(|(at, _)| *at)));
        return Err(table.refuse_number(line, column, message));
    }
    let along = evenly_spaced(range, ALONG);
    let curves = places.read(&along, &columns)?;
    let quantity = |(index, (stated, measured)): (usize, (Stated, Vec<f64>))| {
        let scale = stated.scale;
        let of_model = |numbers: &Option<Vec<f64>>| {
            let number = numbers.as_ref().map_or(f64::NAN, |numbers| numbers[index]);
            number * scale
        };
        let pairs = model.iter().map(of_model).zip(measured);
        let pairs = at.iter().copied().zip(pairs.map(<[f64; 2]>::from));
        Quantity {
            title: stated.named.title,
            symbol: stated.symbol,
            places: pairs.filter(|(_, [model, _])| model.is_finite()).collect(),
            curve: along
                .iter()
                .copied()
                .zip(curves.iter().map(of_model))
                .collect(),
        }
    };
    Ok(stated
        .into_iter()
        .zip(measured)
        .enumerate()
        .map(quantity)
        .collect())
}
