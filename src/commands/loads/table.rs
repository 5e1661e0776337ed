//! The table of loads: a row a place.

use nalgebra::Vector3;

use crate::commands::loads::found::Found;
use crate::commands::loads::report::{unit_in, unit_of};
use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::loads::{Outcome, Structure};
use crate::mechanism::State;
use crate::output::heading::{Header, Heading};
use crate::output::rows::{Forms, Rows};
use crate::quantities::{self, Column, Quantity, Reader, catalogue};

/// Writes the leading quantities and what each case does, a row a state.
pub(super) fn write(
    mechanism: &dyn Kinematics,
    structure: &Structure<'_>,
    (leading, states): (&[&Quantity], &[State]),
    found: &[Found<'_>],
    forms: &Forms,
) -> Result<(), Failure> {
    let columns = quantities::columns(catalogue(), &mechanism.names).into_iter();
    let is_leading = |column: &Column| leading.iter().any(|quantity| column.is(quantity));
    let columns: Vec<_> = columns.filter(is_leading).collect();
    let names = found
        .iter()
        .flat_map(|found| names(mechanism, structure, found));
    let leading = columns.iter().map(|column| column.csv_name(mechanism.unit));
    let heading = |name| Heading {
        name,
        counts: false,
    };
    let headings: Vec<Heading> = leading.chain(names).map(heading).collect();
    let mut file = Rows::create(forms, &Header::of(mechanism), &headings)?;
    for (place, state) in states.iter().enumerate() {
        let reader = Reader::of(state);
        let columns = columns.iter();
        let mut row: Vec<f64> = columns
            .map(|column| column.read(&reader).value * column.kind.in_file(mechanism.unit))
            .collect();
        for found in found {
            match &found.outcomes[place] {
                Some(outcome) => row.extend(numbers(outcome)),
                None => row.extend(numbers(&found.first).map(|_| f64::NAN)),
            }
        }
        file.add(&row)?;
    }
    file.finish()
}

/// The names of the columns of a case.
fn names(mechanism: &dyn Kinematics, structure: &Structure<'_>, found: &Found<'_>) -> Vec<String> {
    let (case, shape, statements) = (&found.case.name, &found.first, &structure.statements);
    let drives = mechanism.names.drives.iter();
    let drives = drives.map(|drive| {
        let unit = unit_of(drive).replace(' ', "");
        format!("{case}_{}_{unit}", drive.name)
    });
    let bearing = shape.in_measures.iter();
    let bearing = bearing.map(|(measure, _)| {
        let measure = &mechanism.names.measures[*measure];
        format!(
            "{case}_{}_{}",
            measure.name,
            unit_in(measure).replace(' ', "")
        )
    });
    let links = shape.links.iter();
    let links = links.map(|(statement, _)| format!("{case}_{}_N", statements[*statement].name));
    let joints = shape.joints.iter().flat_map(|(statement, point, _)| {
        let statement = statements[*statement].name;
        let point = &mechanism.names.points[*point];
        ["x", "y", "z"].map(|axis| format!("{case}_{statement}_{point}_{axis}_N"))
    });
    drives.chain(bearing).chain(links).chain(joints).collect()
}

fn numbers(outcome: &Outcome) -> impl Iterator<Item = f64> {
    let drives = outcome.on_drives.iter().copied();
    let bearing = outcome.in_measures.iter().map(|(_, along)| *along);
    let links = outcome.links.iter().map(|(_, force)| *force);
    let joints = outcome.joints.iter();
    let joints =
        joints.flat_map(|(_, _, force): &(usize, usize, Vector3<f64>)| [force.x, force.y, force.z]);
    drives.chain(bearing).chain(links).chain(joints)
}
