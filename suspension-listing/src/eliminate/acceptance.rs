//! The pivots that are large enough, and the positions in which they are.

/// A pivot must be at least this part of the largest entry of its column in the design position,
/// so that multipliers stay below 5 there.
pub const THRESHOLD: f64 = 0.2;

/// The same in the other positions of the motion, and in designs that may be meant.
const THRESHOLD_ELSEWHERE: f64 = 0.05;

/// Nor may it be smaller than this: entries are of order 1, and what is left of one that cancels
/// is rounding.
const TINY: f64 = 1e-6;

/// What the positions are that pivots are judged by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Positions {
    /// A design and others on its motion: pivots must be large enough in all of them.
    OfMotion,
    /// Designs that may be meant: pivots should be large enough in as many as can be.
    OfDesigns,
}

/// The positions in which all pivots up to here are large enough.
#[derive(Clone)]
pub(super) struct Acceptance {
    of: Positions,
    serves: Vec<bool>,
}

impl Acceptance {
    pub(super) fn new(of: Positions, count: usize) -> Self {
        let serves = vec![true; count];
        Self { of, serves }
    }

    /// How large a pivot must be, in each position, beside the other entries of its column.
    pub(super) fn least<'a>(&self, column: impl Iterator<Item = &'a [f64]>) -> Vec<f64> {
        let mut least = vec![TINY; self.serves.len()];
        for values in column {
            for (position, (least, value)) in least.iter_mut().zip(values).enumerate() {
                let threshold = if position == 0 && self.of == Positions::OfMotion {
                    THRESHOLD
                } else {
                    THRESHOLD_ELSEWHERE
                };
                *least = least.max(threshold * value.abs());
            }
        }
        least
    }

    /// In how many positions an order is no longer good with a pivot of these values; `None` where it must
    /// not be the pivot. One whose values are not known is large enough because it is there.
    pub(super) fn lost(&self, values: &[f64], least: &[f64]) -> Option<usize> {
        let lost = self.serves.iter().zip(values).zip(least);
        let lost = lost.filter(|((serves, value), least)| **serves && value.abs() < **least);
        let lost = lost.count();
        match self.of {
            Positions::OfMotion if lost > 0 || changes_sign(values) => None,
            _ => Some(lost),
        }
    }

    /// Takes a pivot of these values; returns whether fewer positions are served.
    pub(super) fn take(&mut self, values: &[f64], least: &[f64]) -> bool {
        let before = self.count();
        for ((serves, value), least) in self.serves.iter_mut().zip(values).zip(least) {
            *serves &= value.abs() >= *least;
        }
        self.count() < before
    }

    /// Of an entry's values those in positions that count.
    pub(super) fn known<'a>(&'a self, values: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
        let known = values.iter().zip(&self.serves);
        known.filter_map(|(value, serves)| serves.then_some(*value))
    }

    pub(super) fn count(&self) -> usize {
        self.serves.iter().filter(|serves| **serves).count()
    }
}

/// Whether a pivot with these values is zero somewhere on the way from the design.
fn changes_sign(values: &[f64]) -> bool {
    let first = values.first().copied().unwrap_or_default();
    values.iter().any(|value| value * first < 0.0)
}
