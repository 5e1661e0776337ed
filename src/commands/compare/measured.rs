//! A suspension beside a table of measured numbers.

mod columns;
mod course;
mod doubts;
mod heading;
mod measured_quantity;
mod model_at_places;
mod opposite;
mod out_of_reach;
mod position_columns;
mod quantities;
mod rig_names;
mod smoothing;

use std::path::Path;
use std::sync::atomic::AtomicBool;

use crate::commands::compare::differences::{Difference, Part};
use crate::commands::compare::report::Report;
use crate::commands::compare::short_name::short_names;
use crate::failure::Failure;
use crate::file::Source;
use crate::measured_table::MeasuredTable;
use crate::mechanism::CountedFrom;
use crate::number::counted;
use crate::output::notes::with_notes_printed;
use crate::prepare::Loaded;
use columns::{KnownColumn, tell_doubts};
use course::{Course, followed};
use measured_quantity::MeasuredQuantity;
use model_at_places::MovedModel;
use opposite::opposite;
use position_columns::divide;
use quantities::quantities;

/// Returns whether a file is a table, by the end of its name.
pub(super) fn is_table(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    ["csv", "tsv", "txt"].iter().any(|table| ending == *table)
}

/// Compares a suspension with a table, whose drives count `from` the design position or from zero.
///
/// # Errors
///
/// [`Failure::Input`] at a heading, at a field without a number, and at a place out of reach.
pub(super) fn compare(
    (model, loaded): (&Source, &Loaded<'_>),
    measured: &Source,
    from: CountedFrom,
    interrupted: &AtomicBool,
) -> Result<Report, Failure> {
    let mechanism = &*with_notes_printed(loaded.at_design()?);
    let mut table = MeasuredTable::new(measured)?;
    let known = KnownColumn::all(&mut table, mechanism, from)?;
    let [leads, compared] = divide(&table, mechanism, known)?;
    check_content(&table, &leads, &compared)?;
    tell_doubts(&table, mechanism, &leads);
    let course = Course::new(&table, mechanism, &leads);
    let moved = MovedModel {
        file: model.name(),
        mechanism,
        leads: &leads,
        interrupted,
    };
    let quantities = quantities(&table, &moved, &course, compared)?;
    let files = [model, measured].map(|file| file.name().to_owned());
    let names = short_names([&files[0], &files[1]]);
    let charts = quantities.iter();
    let charts = charts.map(|quantity| quantity.chart(&names, &course.label));
    let unknown = quantities.iter().filter_map(MeasuredQuantity::unknown);
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
        notes: followed(&leads)
            .into_iter()
            .chain(unknown)
            .chain(opposite(&quantities, &course))
            .collect(),
        missing: Vec::new(),
        parts: parts(&quantities, &course.label),
        charts: vec![(heading_of_charts(&course), charts.collect())],
    })
}

/// Returns the heading of the charts, which says if they do not show all places.
fn heading_of_charts(course: &Course) -> String {
    let shown = match course.stride {
        1 => String::new(),
        stride => {
            format!("; 1 of {stride} measured places is drawn, and that of the largest difference")
        }
    };
    format!("Over {}{shown}", course.title)
}

/// Compares the numbers as they are measured, and without the offset of each quantity.
fn parts(quantities: &[MeasuredQuantity], across: &str) -> Vec<Part> {
    let part =
        |of: &str, heading: &str, difference: fn(&MeasuredQuantity) -> Option<Difference>| Part {
            of: of.to_owned(),
            heading: format!("{heading}, at a {across}"),
            across: Some(across.to_owned()),
            differences: quantities.iter().filter_map(difference).collect(),
        };
    let at_design = "Offset: the smoothed difference (B is A with it) at the measured place nearest to the design position";
    vec![
        part(
            "as measured",
            "Largest difference as measured",
            MeasuredQuantity::largest,
        ),
        part("offset", at_design, MeasuredQuantity::offset),
        part(
            "without offset",
            "Largest difference without offset",
            MeasuredQuantity::largest_without_offset,
        ),
    ]
}

/// Refuses a table without lines, or without a quantity.
fn check_content(
    table: &MeasuredTable,
    leads: &[KnownColumn],
    compared: &[KnownColumn],
) -> Result<(), Failure> {
    if table.lines() > 0 && !compared.is_empty() {
        return Ok(());
    }
    let message = "the table needs a column of a quantity beside this one, as `toe [deg]`, and lines of numbers; suspension \
                   sweep writes a table with the names of all";
    Err(table.refuse_heading(leads[0].column, message))
}
