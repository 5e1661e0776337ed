//! Notes on drives that bear loads while the springs of the file bear nothing, or only those of one side do; and on bushes
//! that share a load.

use std::collections::BTreeMap;

use nalgebra::Vector3;

use crate::commands::loads::found::Found;
use crate::loads::{OneSided, Structure, Unborne};
use crate::mechanism::{Names, listed};

/// What to write for springs to bear the loads of drives: one note for all cases in which the same drives bear them.
pub(super) fn springs_bear_nothing(
    file: &str,
    names: &Names,
    found: &[Option<Found<'_>>],
) -> Vec<String> {
    let by_springs = alike(found, |unborne| &unborne.by_springs);
    let by_springs = by_springs
        .iter()
        .map(|(drives, cases)| own_springs(names, drives, cases));
    let one_sided = alike(found, |unborne| &unborne.one_sided);
    let one_sided = one_sided
        .iter()
        .map(|(drives, cases)| other_side(names, drives, cases));
    let notes = by_springs.chain(one_sided);
    notes.map(|note| format!("note: {file}: {note}")).collect()
}

/// The hinges on two bushes that bear a load, and that its parts along their axes are assumed.
pub(super) fn shared_along_hinges(
    file: &str,
    (names, structure): (&Names, &Structure<'_>),
    found: &[Option<Found<'_>>],
) -> Option<String> {
    let joints = found.iter().flatten().flat_map(|found| &found.first.joints);
    let shared = joints
        .filter(|(by, _, force)| structure.is_on_two_bushes(*by) && *force != Vector3::zeros());
    let mut hinges: Vec<String> = Vec::new();
    for (by, ..) in shared {
        let name = format!("`{}`", structure.name_of(*by, names));
        if !hinges.contains(&name) {
            hinges.push(name);
        }
    }
    let of = match hinges.as_slice() {
        [] => return None,
        [_] => "the hinge",
        _ => "the hinges",
    };
    Some(format!(
        "note: {file}: each of the two bushes of {of} {} is given half of the load along the axis: rigid parts do not determine the \
         shares",
        listed(hinges)
    ))
}

/// The cases in which drives are borne alike, by their names.
fn alike<'a, T: Ord>(
    found: &'a [Option<Found<'_>>],
    of: fn(&Unborne) -> &Vec<T>,
) -> BTreeMap<&'a [T], Vec<&'a str>> {
    let mut cases: BTreeMap<&[T], Vec<&str>> = BTreeMap::new();
    for found in found.iter().flatten() {
        let unborne = of(&found.unborne);
        if !unborne.is_empty() {
            cases.entry(unborne).or_default().push(&found.case.name);
        }
    }
    cases
}

/// Drives whose loads springs of the file could bear.
fn own_springs(names: &Names, unborne: &[(usize, usize)], cases: &[&str]) -> String {
    let drives = unborne.iter().map(|(drive, _)| *drive);
    let lines = unborne.iter().map(|(drive, spring)| {
        let (drive, spring) = (&names.drives[*drive], &names.vehicle.springs[*spring]);
        format!("{} = \"{}\"", drive.name, spring.name)
    });
    let it = if unborne.len() == 1 {
        "spring"
    } else {
        "springs"
    };
    format!(
        "{}, and no spring does; write {} there for the {it} to bear it",
        bear(names, drives, cases),
        listed(lines)
    )
}

/// Drives that have no spring, while those of the other side have.
fn other_side(names: &Names, one_sided: &[OneSided], cases: &[&str]) -> String {
    let drives = one_sided.iter().map(|each| each.drive);
    let springs = one_sided.iter().map(|each| {
        let spring = &names.vehicle.springs[each.spring].name;
        format!("`{spring}` with `{}`", names.drives[each.opposite].name)
    });
    let measure = |each: &OneSided| &names.measures[each.measure].name;
    let stated = one_sided
        .iter()
        .map(|each| format!("along = \"{}\"", measure(each)));
    let lines = one_sided
        .iter()
        .map(|each| format!("{} = \"{}\"", names.drives[each.drive].name, measure(each)));
    let of_each = if one_sided.len() == 1 { "it" } else { "them" };
    format!(
        "{}: no spring of the file moves with {of_each} as {} does; state the other side's too, under [springs.NAME] with {}, and \
         write {} there",
        bear(names, drives, cases),
        listed(springs),
        listed(stated),
        listed(lines)
    )
}

/// That drives bear the loads of cases.
fn bear(names: &Names, drives: impl ExactSizeIterator<Item = usize>, cases: &[&str]) -> String {
    let [subject, bears] = match drives.len() {
        1 => ["drive", "bears"],
        _ => ["drives", "bear"],
    };
    let drives = drives.map(|drive| format!("`{}`", names.drives[drive].name));
    let tables = cases.iter().map(|case| format!("[loads.{case}]"));
    format!(
        "the {subject} {} {bears} the load of {}",
        listed(drives),
        listed(tables)
    )
}
