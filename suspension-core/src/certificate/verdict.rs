//! The result of a proof, or the reason for its failure.

use super::bounds::Bounds;
use super::enclosed::Enclosed;
use crate::arithmetic::scalar::{Real, Scalar};
use crate::error::{Cause, Compared, Explain, Facts, SolveError, messages};

/// Whether a root is proved to lie near a position `q`. Distances are the largest difference in any unknown, in units
/// of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Certificate<T> {
    /// A root lies within `radius` of `q`. No other root lies within `unique_within`, which is at least `radius`, and
    /// the Jacobian is regular at the root.
    Proved {
        /// An upper bound of the distance to the root.
        radius: T,
        /// A lower bound of the distance to any other root.
        unique_within: T,
    },
    /// Nothing is proved: there may be a root near by, or none.
    Unproved {
        /// Which condition of the proof is not met.
        why: Unproved<T>,
    },
}

impl<T> Certificate<T> {
    /// Whether a root is proved.
    pub fn is_proved(&self) -> bool {
        matches!(self, Self::Proved { .. })
    }
}

/// Which condition of the proof is not met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unproved<T> {
    /// No bounds exist: a number is not finite, or the Jacobian has no usable pivots.
    NoBounds {
        /// The equation or unknown concerned.
        cause: SolveError<T>,
    },
    /// `defect >= 1`: to rounding, the computed inverse is not an inverse of the Jacobian.
    NearSingular {
        /// A bound of `|I - A J|`.
        defect: T,
    },
    /// `correction >= bound`: the curvature of the equations is too strong for a correction of this size. Either the
    /// residual is too large, or a singularity is too near. If the correction is only just below the bound, rounding
    /// has used up the margin.
    TooFar {
        /// A bound of `|A F|`, the correction that Newton's method would make, in units of length.
        correction: T,
        /// The bound below which it must stay, in units of length.
        bound: T,
    },
}

impl<T: Real> Explain for Unproved<T> {
    fn facts(&self) -> Facts {
        let (cause, what, value, relation, bound) = match *self {
            Self::NoBounds { cause } => return cause.facts(),
            Self::NearSingular { defect } => (
                Cause::UnprovedNearSingular,
                "the inverse is off by",
                defect,
                "needed less than",
                T::one(),
            ),
            Self::TooFar { correction, bound } => (
                Cause::UnprovedTooFar,
                "correction",
                correction,
                "needed less than",
                bound,
            ),
        };
        Facts {
            compared: Some(Compared::new(what, value, relation, bound)),
            ..Facts::new(cause, None)
        }
    }
}

messages! {
    [T: Real] Unproved<T>;
}

/// The condition of the proof; see [the module](super).
#[inline]
pub(super) fn judge<T: Real>(bounds: &Bounds<T>) -> Certificate<T> {
    let [correction, defect, curvature] =
        [bounds.correction, bounds.defect, bounds.curvature].map(Enclosed::exact);
    let two = Enclosed::constant(2.0);
    let margin = Enclosed::exact(T::one()) - defect;
    if !is_above(margin.least(), T::zero()) {
        let defect = bounds.defect;
        return unproved(Unproved::NearSingular { defect });
    }
    let bound = (margin * margin / (two * curvature)).least();
    if !is_above(bound, bounds.correction) {
        let correction = bounds.correction;
        return unproved(Unproved::TooFar { correction, bound });
    }
    let share = correction / Enclosed::exact(bound);
    let radius = (two * correction / (margin * (two - share))).magnitude();
    let unique_within = (two * margin / curvature - Enclosed::exact(radius)).least();
    if is_above(unique_within, radius) {
        Certificate::Proved {
            radius,
            unique_within,
        }
    } else {
        let correction = bounds.correction;
        unproved(Unproved::TooFar { correction, bound })
    }
}

/// `a > b`; false if either is NaN.
fn is_above<T: Real>(a: T, b: T) -> bool {
    a > b
}

fn unproved<T>(why: Unproved<T>) -> Certificate<T> {
    Certificate::Unproved { why }
}
