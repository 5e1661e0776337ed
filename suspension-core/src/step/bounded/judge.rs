//! The decision to accept a step, or the reason for its refusal.

use super::evidence::Evidence;
use super::{Bounded, Step};
use crate::arithmetic::magnitude::index_of_largest;
use crate::arithmetic::scalar::Real;
use crate::error::{Cause, Explain, Facts, SolveError, messages};
use crate::linkage::Linkage;
use crate::listing::Part;
use crate::model::handedness::{is_right, most_mirrored};
use crate::signal::ChassisMotion;
use crate::solve::motion::Motion;
use crate::solve::report::Report;
use crate::values::Values;

/// The test that a step failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// A position, velocity or acceleration is not finite: an input is NaN or infinite or a result too large, or a
    /// pivot of the fixed order is exactly zero.
    NotFinite,
    /// The error of the prediction exceeds its bound.
    Diverging,
    /// The residual exceeds the tolerance.
    NotConverged,
    /// The determinant has changed its sign.
    CrossedSingularity,
    /// A point that only links hold is mirrored.
    Mirrored,
    /// The pivots of the fixed order are too small; with partial pivoting a step may be possible.
    Unhealthy,
}

impl Explain for Refusal {
    fn facts(&self) -> Facts {
        let cause = match self {
            Self::NotFinite => Cause::Overflow,
            Self::Diverging => Cause::Diverging,
            Self::NotConverged => Cause::NotConverged,
            Self::CrossedSingularity => Cause::CrossedSingularity,
            Self::Mirrored => Cause::Mirrored,
            Self::Unhealthy => Cause::UnhealthyPivots,
        };
        Facts::new(cause, None)
    }
}

messages! {
    [] Refusal;
}

impl<T: Real, const CORRECTIONS: usize, const ORDER: usize> Bounded<T, CORRECTIONS, ORDER> {
    /// The largest residual that is accepted for a linkage of the given size.
    fn residual_tolerance(&self, size: T) -> T {
        self.tolerance.length(T::EPSILON * size)
    }

    /// The error of the prediction that is accepted however short the step is.
    fn smallest_bound(&self, size: T) -> T {
        if CORRECTIONS == 0 {
            self.residual_tolerance(size)
        } else {
            self.correction_of_size * size
        }
    }

    /// The error that is accepted for a step that has `moved` this far.
    fn bound(&self, size: T, moved: impl FnOnce() -> T) -> T {
        let smallest = self.smallest_bound(size);
        if CORRECTIONS == 0 {
            smallest
        } else {
            smallest.max(self.correction_of_move * moved())
        }
    }

    /// Accepts a step of a linkage of the given size, or tells which test it failed. `before` is the sign of the
    /// determinant at the last motion, if known. `moved` gives the distance from its position and is called only if
    /// the error of the prediction is not small by itself.
    ///
    /// # Errors
    ///
    /// [`Refusal`].
    #[inline]
    pub fn judge(
        &self,
        size: T,
        evidence: &Evidence<T>,
        before: Option<bool>,
        moved: impl FnOnce() -> T,
    ) -> Result<Report<T>, Refusal> {
        let tolerance = self.residual_tolerance(size);
        let is_positive = evidence.determinant_sign > T::zero();
        let is_root = tolerance >= T::zero() && evidence.residual_squared <= tolerance * tolerance;
        let error_squared = evidence.error_squared;
        let is_within = |bound: T| error_squared <= bound * bound;
        let is_near = is_within(self.smallest_bound(size))
            || CORRECTIONS > 0 && is_within(self.bound(size, moved));
        if !error_squared.is_finite() || !evidence.rates_squared.is_finite() {
            Err(Refusal::NotFinite)
        } else if !is_near {
            Err(Refusal::Diverging)
        } else if !is_root {
            Err(Refusal::NotConverged)
        } else if before.is_some_and(|before| before != is_positive) {
            Err(Refusal::CrossedSingularity)
        } else if !is_right(evidence.mirrored) {
            Err(Refusal::Mirrored)
        } else {
            Ok(Report {
                tolerance,
                residual_squared: evidence.residual_squared,
                error_squared,
                growth_squared: evidence.growth_squared,
                steps: 1,
                iterations: 1,
            })
        }
    }
}

impl<T, L, C, const N: usize, const CORRECTIONS: usize, const ORDER: usize>
    Step<'_, L, C, N, CORRECTIONS, ORDER>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
    C: ChassisMotion<L::Fixed>,
{
    /// The distance that the step goes.
    #[cold]
    #[inline(never)]
    pub(super) fn moved(&self, next: &Motion<T, N>) -> T {
        (next.position - self.from.position).norm()
    }

    /// The refusal in full, with the equation or unknown concerned.
    #[cold]
    #[inline(never)]
    pub(super) fn explain(
        &self,
        settings: &Bounded<T, CORRECTIONS, ORDER>,
        refusal: Refusal,
        next: &Motion<T, N>,
        evidence: &Evidence<T>,
    ) -> SolveError<T> {
        let fixed = &self.prescribed.fixed.value;
        let size = self.linkage.size();
        match refusal {
            Refusal::NotFinite => SolveError::Overflow {
                part: (self.drive_without_rate().map(Part::Drive))
                    .unwrap_or_else(|| Part::Unknown(not_finite(next))),
            },
            Refusal::Diverging => SolveError::Diverging {
                part: Part::Unknown(index_of_largest(
                    &(self.prediction.position - next.position),
                )),
                step: evidence.error_squared.sqrt(),
                bound: settings.bound(size, || self.moved(next)),
            },
            Refusal::NotConverged => SolveError::NotConverged {
                part: Part::Equation(index_of_largest(&self.residual_called(&next.position))),
                residual: evidence.residual_squared.sqrt(),
                tolerance: settings.residual_tolerance(size),
                iterations: CORRECTIONS,
            },
            // Small pivots make an attempt refuse: with partial pivoting they can only mean a singularity near by.
            Refusal::CrossedSingularity | Refusal::Unhealthy => SolveError::CrossedSingularity {
                part: Part::Unknown(index_of_largest(&(next.position - self.from.position))),
            },
            Refusal::Mirrored => SolveError::Mirrored {
                part: most_mirrored(self.linkage, &next.position, fixed),
            },
        }
    }

    /// The first drive with a rate that is not finite. It is the cause: the rates of all unknowns that it moves are not
    /// finite either.
    fn drive_without_rate(&self) -> Option<usize> {
        let drives = &self.prescribed.drives;
        let mut rates = drives.rate.values().zip(drives.second_rate.values());
        rates.position(|(rate, second_rate)| !rate.is_finite() || !second_rate.is_finite())
    }
}

/// The first unknown that is not finite, or has a rate that is not; otherwise the one with the largest acceleration.
fn not_finite<T: Real, const N: usize>(motion: &Motion<T, N>) -> usize {
    let vectors = [&motion.position, &motion.velocity, &motion.acceleration];
    let first = (vectors.into_iter()).find_map(|vector| vector.iter().position(|x| !x.is_finite()));
    first.unwrap_or_else(|| index_of_largest(&motion.acceleration))
}
