//! The table of loads: one row per place.

use crate::commands::loads::case_results::CaseResults;
use crate::commands::loads::parts::{Part, parts};
use crate::commands::loads::place_columns::PlaceColumns;
use crate::loads::{Outcome, Structure};
use crate::mechanism::Description;
use crate::output::heading::Heading;

/// Returns the headings of the leading quantities and of each case.
pub(super) fn headings(
    mechanism: &Description,
    structure: &Structure<'_>,
    leading: &PlaceColumns,
    found: &[Option<CaseResults<'_>>],
) -> Vec<Heading> {
    let found = found.iter().flatten();
    let names = found.flat_map(|found| names(mechanism, structure, found));
    leading.names().chain(names).map(Heading::new).collect()
}

/// Returns a row: the numbers of the place, then those of each case that has an answer anywhere, with NaN if it has none
/// here.
pub(super) fn row(
    place: &[f64],
    found: &[Option<CaseResults<'_>>],
    outcomes: &[Option<Outcome>],
) -> Vec<f64> {
    let mut row = place.to_vec();
    for (found, outcome) in found.iter().zip(outcomes) {
        match (found, outcome) {
            (Some(_), Some(outcome)) => row.extend(numbers(outcome)),
            (Some(found), None) => row.extend(numbers(&found.first).map(|_| f64::NAN)),
            (None, _) => {}
        }
    }
    row
}

/// Returns the names of a case's columns.
fn names(
    mechanism: &Description,
    structure: &Structure<'_>,
    found: &CaseResults<'_>,
) -> Vec<String> {
    let (names, case) = (&mechanism.names, &found.case.name);
    let name = |part: Part| match part {
        Part::Drive(drive) => names.drives[drive].name.clone(),
        Part::Measure(measure) => names.measures[measure].name.clone(),
        Part::Link(link) => structure.statements[link].name.to_owned(),
        Part::Joint(by, at) => format!("{}_{}", structure.name_of(by, names), names.points[at]),
        Part::Moment(by, on) => {
            let by = structure.name_of(by, names);
            format!("{by}_{}", structure.statements[on].name)
        }
        Part::ChassisPoint(point) => format!("on_chassis_{}", names.points[point]),
    };
    let columns = parts(&found.first).flat_map(|(part, load)| {
        let (name, unit) = (name(part), part.unit(names).replace(' ', ""));
        let numbers = load.numbers().into_iter();
        numbers.map(move |(axis, _)| format!("{case}_{name}{axis}_{unit}"))
    });
    columns.collect()
}

fn numbers(outcome: &Outcome) -> impl Iterator<Item = f64> {
    let numbers = parts(outcome).flat_map(|(_, load)| load.numbers());
    numbers.map(|(_, number)| number)
}
