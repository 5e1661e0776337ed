//! What a load case does at each place.

use crate::failure::Failure;
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
    /// [`Failure::Solver`] where the case does nothing at any place.
    pub(super) fn new(
        file: &str,
        case: &'a Case,
        outcomes: Vec<Option<Outcome>>,
    ) -> Result<Self, Failure> {
        let Some(first) = outcomes.iter().flatten().next().cloned() else {
            return Err(Failure::Solver(format!(
                "{file}: load case `{}` has no answer: the drives lock, or the measure that is to bear the load of a drive does \
                 not change with it",
                case.name
            )));
        };
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
