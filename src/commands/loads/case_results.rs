//! The results of a load case over all places.

use std::collections::BTreeSet;
use std::rc::Rc;

use crate::commands::loads::parts::{Part, parts};
use crate::loads::{By, Case, Outcome, Unborne};
use crate::mechanism::State;

/// The results of a case over all places that have an answer.
pub(super) struct CaseResults<'a> {
    pub(super) case: &'a Case,
    /// The outcome at the first place: the parts are the same at all places.
    pub(super) first: Outcome,
    /// Drives that bear loads at the first place.
    pub(super) unborne: Unborne,
    /// The springs by number that are stretched or twisted at any place, but have no load.
    pub(super) left_out: BTreeSet<usize>,
    /// The springs by number that act by their rates, but have no load at any place.
    pub(super) unstretched: BTreeSet<usize>,
    /// The number of places.
    pub(super) places: usize,
    /// The numbers of the first place, and which of them vary over the places.
    pub(super) place: Rc<[f64]>,
    pub(super) varies: Vec<bool>,
    /// The least and the greatest load of each of the [`parts`], of loads in space that of their magnitudes.
    pub(super) ranges: Vec<[Extreme; 2]>,
    /// The largest [`Outcome::amplification`].
    pub(super) amplification: Extreme,
}

/// The least or the greatest of a number, and its place.
#[derive(Clone)]
pub(super) struct Extreme {
    pub(super) value: f64,
    pub(super) place: Rc<[f64]>,
}

impl<'a> CaseResults<'a> {
    /// Starts the results of a case, before the first place is counted.
    pub(super) fn new(
        (case, unborne): (&'a Case, Unborne),
        first: Outcome,
        place: &Rc<[f64]>,
    ) -> Self {
        let extreme = |value| Extreme {
            value,
            place: place.clone(),
        };
        let nothing = [f64::INFINITY, f64::NEG_INFINITY].map(extreme);
        Self {
            case,
            unborne,
            left_out: BTreeSet::new(),
            unstretched: case.acting.iter().copied().collect(),
            places: 0,
            place: place.clone(),
            varies: vec![false; place.len()],
            ranges: sizes(&first).map(|_| nothing.clone()).collect(),
            amplification: extreme(0.0),
            first,
        }
    }

    /// Adds the outcome at a place.
    pub(super) fn add(&mut self, outcome: &Outcome, (state, place): (&State, &Rc<[f64]>)) {
        self.places += 1;
        self.left_out.extend(self.case.left_out(state));
        for spring in self.case.loaded(state) {
            self.unstretched.remove(&spring);
        }
        for ((varies, first), here) in self.varies.iter_mut().zip(&*self.place).zip(&**place) {
            *varies |= first != here;
        }
        let amplification = outcome.amplification();
        if amplification > self.amplification.value {
            self.amplification.set(amplification, place);
        }
        for ([least, greatest], size) in self.ranges.iter_mut().zip(sizes(outcome)) {
            if size < least.value {
                least.set(size, place);
            }
            if size > greatest.value {
                greatest.set(size, place);
            }
        }
    }

    /// Whether a part exerts a force at a joint, at any place.
    pub(super) fn bears(&self, part: By) -> bool {
        let mut each = parts(&self.first).zip(&self.ranges);
        each.any(|((loaded, _), range)| {
            matches!(loaded, Part::Joint(by, _) if by == part) && Extreme::largest(range) != 0.0
        })
    }
}

impl Extreme {
    /// Returns the largest magnitude of a number.
    pub(super) fn largest([least, greatest]: &[Self; 2]) -> f64 {
        least.value.abs().max(greatest.value.abs())
    }

    fn set(&mut self, value: f64, place: &Rc<[f64]>) {
        *self = Self {
            value,
            place: place.clone(),
        };
    }
}

/// Returns a number for each part, in the order of [`CaseResults::ranges`].
fn sizes(outcome: &Outcome) -> impl Iterator<Item = f64> {
    parts(outcome).map(|(_, load)| load.size())
}

/// Returns a sentence on the cases without an answer; `None` if all have one.
pub(super) fn without_answer(file: &str, cases: &[&str]) -> Option<String> {
    let names: Vec<String> = cases.iter().map(|name| format!("`{name}`")).collect();
    let [what, has] = match cases {
        [] => return None,
        [_] => ["case", "has"],
        _ => ["cases", "have"],
    };
    Some(format!(
        "{file}: load {what} {} {has} no answer: the drives lock, or the measure that is to bear the load of a drive does not change with it",
        names.join(", ")
    ))
}
