//! The pivots that are large enough, and the positions in which they are.

/// The smallest pivot in the design position, as a fraction of the largest entry of its column, so that multipliers
/// stay below 5 there.
pub const THRESHOLD: f64 = 0.2;

/// The smallest such fraction in the other positions of the motion, and in likely designs.
const THRESHOLD_ELSEWHERE: f64 = 0.05;

/// The smallest pivot in any case: entries are of order 1, and the remainder of one that cancels is a rounding error.
const TINY: f64 = 1e-6;

/// The positions by which pivots are judged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Positions {
    /// A design and others on its motion: pivots must be large enough in all of them.
    OfMotion,
    /// Likely designs: pivots should be large enough in as many of them as possible.
    OfDesigns,
}

/// The positions in which all pivots so far are large enough.
#[derive(Clone)]
pub(super) struct Acceptance {
    judged_by: Positions,
    serves: Vec<bool>,
}

impl Acceptance {
    pub(super) fn new(judged_by: Positions, count: usize) -> Self {
        let serves = vec![true; count];
        Self { judged_by, serves }
    }

    /// The smallest permitted pivot, in each position, given the other entries of its column.
    pub(super) fn least<'a>(&self, column: impl Iterator<Item = &'a [f64]>) -> Vec<f64> {
        let mut least = vec![TINY; self.serves.len()];
        for values in column {
            for (position, (least, value)) in least.iter_mut().zip(values).enumerate() {
                let threshold = if position == 0 && self.judged_by == Positions::OfMotion {
                    THRESHOLD
                } else {
                    THRESHOLD_ELSEWHERE
                };
                *least = least.max(threshold * value.abs());
            }
        }
        least
    }

    /// The number of positions in which an order is no longer good with a pivot of these values; `None` if it must
    /// not be the pivot. A pivot whose values are not known counts as large enough because it is there.
    pub(super) fn count_lost(&self, values: &[f64], least: &[f64]) -> Option<usize> {
        let lost = self.serves.iter().zip(values).zip(least);
        let lost = lost.filter(|((serves, value), least)| **serves && value.abs() < **least);
        let lost = lost.count();
        match self.judged_by {
            Positions::OfMotion if lost > 0 || changes_sign(values) => None,
            _ => Some(lost),
        }
    }

    /// Accepts a pivot of these values; returns whether fewer positions are served.
    pub(super) fn accept(&mut self, values: &[f64], least: &[f64]) -> bool {
        let before = self.count();
        for ((serves, value), least) in self.serves.iter_mut().zip(values).zip(least) {
            *serves &= value.abs() >= *least;
        }
        self.count() < before
    }

    /// The values of an entry in the positions that count.
    pub(super) fn known<'a>(&'a self, values: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
        let known = values.iter().zip(&self.serves);
        known.filter_map(|(value, serves)| serves.then_some(*value))
    }

    pub(super) fn count(&self) -> usize {
        self.serves.iter().filter(|serves| **serves).count()
    }
}

/// Whether a pivot with these values passes zero on the way from the design.
fn changes_sign(values: &[f64]) -> bool {
    let first = values.first().copied().unwrap_or_default();
    values.iter().any(|value| value * first < 0.0)
}
