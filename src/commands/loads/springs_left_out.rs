//! Notes on springs that do not act in load cases although the places stretch or twist them, and on those that act and
//! bear nothing because no place does.

use std::collections::{BTreeMap, BTreeSet};

use crate::commands::loads::found::Found;
use crate::mechanism::{Names, listed};

/// Returns one note for all cases with the same springs. Springs that could bear the load of a drive have a note of their own.
pub(super) fn springs_left_out(
    file: &str,
    names: &Names,
    found: &[Option<Found<'_>>],
) -> Vec<String> {
    let mut cases: BTreeMap<[Vec<usize>; 2], Vec<&str>> = BTreeMap::new();
    for found in found.iter().flatten() {
        let is_noted = |spring: &usize| {
            let mut noted = found.unborne.by_springs.iter();
            noted.any(|(_, by)| by == spring)
        };
        let left_out = found.left_out.iter().copied();
        let left_out: Vec<usize> = left_out.filter(|spring| !is_noted(spring)).collect();
        if !left_out.is_empty() {
            let springs = [left_out, found.case.acting.clone()];
            cases.entry(springs).or_default().push(&found.case.name);
        }
    }
    let each = cases.iter();
    each.map(|([left_out, acting], cases)| {
        let note = note(names, [left_out, acting], cases);
        format!("note: {file}: {note}")
    })
    .collect()
}

/// Returns one note for all cases in which the same springs act and bear nothing at any place.
pub(super) fn springs_without_load(
    file: &str,
    names: &Names,
    found: &[Option<Found<'_>>],
) -> Vec<String> {
    let mut cases: BTreeMap<&BTreeSet<usize>, Vec<&str>> = BTreeMap::new();
    for found in found.iter().flatten() {
        if !found.unstretched.is_empty() {
            let of_springs = cases.entry(&found.unstretched).or_default();
            of_springs.push(&found.case.name);
        }
    }
    let each = cases.iter().map(|(springs, cases)| {
        let [spring, acts, bears, measure] = match springs.len() {
            1 => ["spring", "acts", "bears", "its measure is"],
            _ => ["springs", "act", "bear", "their measures are"],
        };
        let quoted = springs.iter();
        let quoted = quoted.map(|spring| format!("`{}`", names.vehicle.springs[*spring].name));
        let tables = cases.iter().map(|case| format!("[loads.{case}]"));
        format!(
            "note: {file}: the {spring} {} {acts} in {} and {bears} nothing: {measure} as at the design position at every place; move a drive \
             with --drive, or state a load at the design position, load = ..., under [springs.NAME]",
            listed(quoted),
            listed(tables)
        )
    });
    each.collect()
}

fn note(names: &Names, [left_out, acting]: [&[usize]; 2], cases: &[&str]) -> String {
    let name = |spring: &usize| names.vehicle.springs[*spring].name.as_str();
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
    let quoted = left_out.iter().map(|spring| format!("`{}`", name(spring)));
    let tables = cases.iter().map(|case| format!("[loads.{case}]"));
    let together = acting.iter().chain(left_out).map(name);
    let together: Vec<&str> = together.collect();
    format!(
        "the {springs} {} {act} in {}, although {their}; write acting = {together:?} there for {rates}",
        listed(quoted),
        listed(tables)
    )
}
