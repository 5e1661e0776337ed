//! Notes on drives whose loads springs of the file could bear, on springs that bear nothing, and on joints that share a load.

use std::collections::BTreeMap;

use crate::commands::loads::case_results::CaseResults;
use crate::loads::{By, OneSided, Site, Structure, contact_of};
use crate::mechanism::{Axes, Names, listed, quoted};

/// Returns the notes on the results of all cases; cases with the same drives or springs share one.
pub(super) fn notes(
    (names, axes): (&Names, Axes),
    structure: &Structure<'_>,
    found: &[Option<CaseResults<'_>>],
) -> Vec<String> {
    let by_springs = alike(found, |found| some(&found.unborne.by_springs));
    let by_springs = by_springs
        .iter()
        .map(|(drives, cases)| own_springs(names, drives, cases));
    let one_sided = alike(found, |found| some(&found.unborne.one_sided));
    let one_sided = one_sided
        .iter()
        .map(|(drives, cases)| other_side(names, drives, cases));
    let left_out = alike(found, |found| {
        let left_out = left_out(found);
        (!left_out.is_empty()).then(|| [left_out, found.case.acting.clone()])
    });
    let left_out = left_out
        .iter()
        .map(|([left_out, acting], cases)| does_not_act(names, [left_out, acting], cases));
    let unstretched = alike(found, |found| {
        let unstretched: Vec<usize> = found.unstretched.iter().copied().collect();
        (!unstretched.is_empty()).then_some(unstretched)
    });
    let unstretched = unstretched
        .iter()
        .map(|(springs, cases)| bears_nothing(names, springs, cases));
    let pulled_down = alike(found, |found| pulled_down(found, axes));
    let pulled_down = pulled_down
        .iter()
        .map(|(wheel, cases)| pulls_down((names, *wheel), cases, axes));
    let notes = by_springs.chain(one_sided).chain(left_out);
    let notes = notes.chain(unstretched).chain(pulled_down);
    notes
        .chain(shared_along_lines(names, structure, found))
        .collect()
}

/// Returns a list that is not empty.
fn some<T>(list: &[T]) -> Option<&[T]> {
    (!list.is_empty()).then_some(list)
}

/// Groups the cases that have the same of something.
fn alike<'a, K: Ord>(
    found: &'a [Option<CaseResults<'_>>],
    of: impl Fn(&'a CaseResults<'_>) -> Option<K>,
) -> BTreeMap<K, Vec<&'a str>> {
    let mut cases: BTreeMap<K, Vec<&str>> = BTreeMap::new();
    for found in found.iter().flatten() {
        if let Some(key) = of(found) {
            cases.entry(key).or_default().push(&found.case.name);
        }
    }
    cases
}

/// Returns the springs that do not act although a place stretches or twists them; those that could bear the load of a drive have
/// a note of their own.
fn left_out(found: &CaseResults<'_>) -> Vec<usize> {
    let is_noted = |spring: &usize| {
        let mut noted = found.unborne.by_springs.iter();
        noted.any(|(_, by)| by == spring)
    };
    let left_out = found.left_out.iter().copied();
    left_out.filter(|spring| !is_noted(spring)).collect()
}

/// Names the tables of cases in the motion file.
fn tables(cases: &[&str]) -> String {
    listed(cases.iter().map(|case| format!("[loads.{case}]")))
}

fn springs_in_words(names: &Names, springs: &[usize]) -> String {
    let springs = springs.iter().map(|spring| &names.vehicle.springs[*spring]);
    quoted(springs.map(|spring| &spring.name))
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
    let drives = drives.map(|drive| &names.drives[drive].name);
    format!(
        "the {subject} {} {bears} the load of {}",
        quoted(drives),
        tables(cases)
    )
}

/// Notes the springs that do not act, beside those that do.
fn does_not_act(names: &Names, [left_out, acting]: [&[usize]; 2], cases: &[&str]) -> String {
    let [springs, act, their, rates] = match left_out.len() {
        1 => [
            "spring",
            "does not act",
            "its measure changes",
            "it to act by its rate",
        ],
        _ => [
            "springs",
            "do not act",
            "their measures change",
            "them to act by their rates",
        ],
    };
    let together = acting.iter().chain(left_out);
    let together = together.map(|spring| names.vehicle.springs[*spring].name.as_str());
    let together: Vec<&str> = together.collect();
    format!(
        "the {springs} {} {act} in {}, although {their}; write acting = {together:?} there for {rates}",
        springs_in_words(names, left_out),
        tables(cases)
    )
}

/// Notes the springs that act and bear nothing at any place.
fn bears_nothing(names: &Names, springs: &[usize], cases: &[&str]) -> String {
    let [spring, acts, bears, measure] = match springs.len() {
        1 => ["spring", "acts", "bears", "its measure is"],
        _ => ["springs", "act", "bear", "their measures are"],
    };
    format!(
        "the {spring} {} {acts} in {} and {bears} nothing: {measure} as at the design position at every place; move a drive \
         with --drive, or state a load at the design position, load = ..., under [springs.NAME]",
        springs_in_words(names, springs),
        tables(cases)
    )
}

/// The first wheel that the ground pulls down.
fn pulled_down(found: &CaseResults<'_>, axes: Axes) -> Option<usize> {
    found
        .case
        .at
        .iter()
        .find_map(|(site, [force, _])| match site {
            Site::Contact(wheel) if axes.turned(*force).z < 0.0 => Some(*wheel),
            _ => None,
        })
}

/// Notes cases in which the ground pulls a wheel down.
fn pulls_down((names, wheel): (&Names, usize), cases: &[&str], axes: Axes) -> String {
    let (cases, contact) = (tables(cases), contact_of(&names.wheels[wheel]));
    let [_, _, up] = axes.signs();
    let sign = if up < 0.0 { "negative" } else { "positive" };
    format!(
        "the force at `{contact}` in {cases} pulls the wheel down: is the sign of its z right? The ground pushes a wheel up, and up is \
         {sign} z in the axes of the file, {}",
        axes.name()
    )
}

/// Notes the hinges on two bushes, and the pairs of bodies with two joints, that bear a load: how its part along their line is
/// shared is an assumption.
fn shared_along_lines(
    names: &Names,
    structure: &Structure<'_>,
    found: &[Option<CaseResults<'_>>],
) -> impl Iterator<Item = String> {
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
            "each of the two {of} is given half of the load along the {line}: rigid parts do not determine the shares"
        )
    })
}
