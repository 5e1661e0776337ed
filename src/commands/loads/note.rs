//! What is said where drives bear loads and the springs of the file bear nothing.

use std::collections::BTreeMap;

use crate::commands::loads::found::Found;
use crate::mechanism::Names;

/// What to write for springs to bear the loads of drives: one note for all cases in which the same drives bear them.
pub(super) fn springs_bear_nothing(
    file: &str,
    names: &Names,
    found: &[Option<Found<'_>>],
) -> Vec<String> {
    let mut cases: BTreeMap<&[(usize, usize)], Vec<&str>> = BTreeMap::new();
    for found in found.iter().flatten() {
        if !found.unborne.is_empty() {
            let alike = cases.entry(&found.unborne).or_default();
            alike.push(&found.case.name);
        }
    }
    let notes = cases.into_iter().map(|(unborne, cases)| {
        let drives = unborne
            .iter()
            .map(|(drive, _)| format!("`{}`", names.drives[*drive].name));
        let lines = unborne.iter().map(|(drive, spring)| {
            let (drive, spring) = (
                &names.drives[*drive].name,
                &names.vehicle.springs[*spring].name,
            );
            format!("{drive} = \"{spring}\"")
        });
        let tables = cases.iter().map(|case| format!("[loads.{case}]"));
        let [subject, is, it] = match unborne {
            [_] => ["drive", "bears", "spring"],
            _ => ["drives", "bear", "springs"],
        };
        format!(
            "note: {file}: the {subject} {} {is} the load of {}, and no spring does; write {} there for the {it} to bear it",
            all(drives),
            all(tables),
            all(lines)
        )
    });
    notes.collect()
}

/// Words as `a, b and c`.
fn all(words: impl Iterator<Item = String>) -> String {
    let words: Vec<String> = words.collect();
    match words.as_slice() {
        [before @ .., last] if !before.is_empty() => format!("{} and {last}", before.join(", ")),
        _ => words.concat(),
    }
}
