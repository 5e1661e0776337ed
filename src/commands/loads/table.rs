//! The table of loads: one row per place.

use crate::commands::loads::case_results::{CaseResults, along, vectors};
use crate::commands::loads::place_columns::PlaceColumns;
use crate::commands::loads::report::unit_of;
use crate::kinematics::Kinematics;
use crate::loads::{Outcome, Structure};
use crate::output::heading::Heading;

/// Returns the headings of the leading quantities and of each case.
pub(super) fn headings(
    mechanism: &dyn Kinematics,
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
    mechanism: &dyn Kinematics,
    structure: &Structure<'_>,
    found: &CaseResults<'_>,
) -> Vec<String> {
    let (case, shape, statements) = (&found.case.name, &found.first, &structure.statements);
    let drives = mechanism.names.drives.iter();
    let drives = drives.map(|drive| {
        let unit = unit_of(drive.kind).replace(' ', "");
        format!("{case}_{}_{unit}", drive.name)
    });
    let bearing = shape.in_measures.iter();
    let bearing = bearing.map(|(measure, _)| {
        let measure = &mechanism.names.measures[*measure];
        format!(
            "{case}_{}_{}",
            measure.name,
            unit_of(measure.kind).replace(' ', "")
        )
    });
    let links = shape.links.iter();
    let links = links.map(|(statement, _)| format!("{case}_{}_N", statements[*statement].name));
    let joints = shape.joints.iter().flat_map(|(by, point, _)| {
        let by = structure.name_of(*by, &mechanism.names);
        let point = &mechanism.names.points[*point];
        ["x", "y", "z"].map(|axis| format!("{case}_{by}_{point}_{axis}_N"))
    });
    let moments = shape.moments.iter().flat_map(|(by, part, _)| {
        let by = structure.name_of(*by, &mechanism.names);
        let part = statements[*part].name;
        ["x", "y", "z"].map(|axis| format!("{case}_{by}_{part}_{axis}_Nm"))
    });
    let along = drives.chain(bearing).chain(links);
    let on_chassis = shape.on_chassis.iter().flat_map(|(point, _)| {
        let point = &mechanism.names.points[*point];
        ["x", "y", "z"].map(|axis| format!("{case}_on_chassis_{point}_{axis}_N"))
    });
    let vectors = joints.chain(moments).chain(on_chassis);
    along.chain(vectors).collect()
}

fn numbers(outcome: &Outcome) -> impl Iterator<Item = f64> {
    let components = vectors(outcome).flat_map(|vector| [vector.x, vector.y, vector.z]);
    along(outcome).chain(components)
}
