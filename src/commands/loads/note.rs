//! Notes on drives whose loads springs of the file could bear, and on joints that share a load.

use std::collections::BTreeMap;

use crate::commands::loads::found::Found;
use crate::loads::{By, OneSided, Structure, Unborne};
use crate::mechanism::{Names, listed};

/// Returns the springs to add so that they bear the loads of drives: one note for all cases with the same drives.
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

/// Notes the hinges on two bushes, and the pairs of bodies with two joints, that bear a load: how its part along their line is
/// shared is an assumption.
pub(super) fn shared_along_lines(
    file: &str,
    (names, structure): (&Names, &Structure<'_>),
    found: &[Option<Found<'_>>],
) -> Vec<String> {
    let bears = |part: By| found.iter().flatten().any(|found| found.bears(part));
    let name = |part: By| format!("`{}`", structure.name_of(part, names));
    let (mut hinges, mut pairs) = (Vec::new(), Vec::new());
    for (part, with) in structure.shared().filter(|(part, _)| bears(*part)) {
        match with {
            None => hinges.push(name(part)),
            Some(with) => pairs.push(format!("{} and {}", name(part), name(with))),
        }
    }
    let of_hinges = match hinges.len() {
        0 => None,
        1 => Some(format!("bushes of the hinge {}", hinges[0])),
        _ => Some(format!("bushes of the hinges {}", listed(hinges))),
    };
    let of_pairs = pairs
        .into_iter()
        .map(|pair| format!("points that {pair} share"));
    let each = of_hinges.map(|of| (of, "axis")).into_iter();
    let each = each.chain(of_pairs.map(|of| (of, "line of these points")));
    each.map(|(of, line)| {
        format!(
            "note: {file}: each of the two {of} is given half of the load along the {line}: rigid parts do not determine the shares"
        )
    })
    .collect()
}

/// Groups the cases in which the same drives bear loads.
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

/// Notes the drives whose loads springs of the file could bear.
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

/// Notes the drives without a spring while drives of the other side have one.
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

/// Says that drives bear the loads of cases.
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
