//! What a load case does at each place.

use crate::loads::{Case, Outcome};

/// A case with what it does at each place, in their order; `None` where the mechanism locks.
pub(super) struct Found<'a> {
    pub(super) case: &'a Case,
    pub(super) outcomes: Vec<Option<Outcome>>,
    /// That of the first place that has one: all have the same parts.
    pub(super) first: Outcome,
}

impl<'a> Found<'a> {
    /// # Errors
    ///
    /// The case's name, where it does nothing at any place.
    pub(super) fn new(case: &'a Case, outcomes: Vec<Option<Outcome>>) -> Result<Self, &'a str> {
        let first = outcomes.iter().flatten().next().cloned();
        let first = first.ok_or(case.name.as_str())?;
        Ok(Self {
            case,
            outcomes,
            first,
        })
    }

    /// Those of all places that have one.
    pub(super) fn all(&self) -> Vec<&Outcome> {
        self.outcomes.iter().flatten().collect()
    }
}

/// What is said of cases without an answer; `None` where all have one.
pub(super) fn without_answer(file: &str, cases: &[&str]) -> Option<String> {
    let names: Vec<String> = cases.iter().map(|name| format!("`{name}`")).collect();
    let what = match cases {
        [] => return None,
        [_] => "case",
        _ => "cases",
    };
    Some(format!(
        "{file}: load {what} {} no answer: the drives lock, or the measure that is to bear the load of a drive does not change with it",
        names.join(", ") + if cases.len() == 1 { " has" } else { " have" }
    ))
}
