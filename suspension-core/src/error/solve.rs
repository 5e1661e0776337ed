//! Errors in solving for a configuration.

use super::{Cause, Compared, Explain, Facts};
use crate::arithmetic::scalar::Real;
use crate::listing::Part;

/// Why no configuration was found. The state that was passed in is unchanged.
///
/// The part is an equation or an unknown, unless the variant says otherwise. On a [`Curve`](crate::path::Curve) it may
/// be the free drive, which stands for its coordinate and for the quantity that leads in its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SolveError<T> {
    /// A residual, or a derivative of it, is NaN or infinite. Either an input or the start is so too, or the number is
    /// too large for the number type.
    NotFinite {
        /// The equation of the residual, or the drive that is NaN or infinite.
        part: Part,
    },
    /// A correction, velocity or acceleration is NaN or infinite, or a force of [`statics`](crate::statics). Either a
    /// rate of an input or a given force is so too, or the number is too large for the number type.
    Overflow {
        /// The unknown that changes, in a bounded step the drive whose rate is not finite; the point of the given force, or
        /// the equation or drive that bears it.
        part: Part,
    },
    /// The determinant of the Jacobian has the opposite sign to that at the last good motion: a singularity lies in
    /// between, and the root belongs to another assembly.
    CrossedSingularity {
        /// The unknown that moved farthest.
        part: Part,
    },
    /// `pivot <= threshold`: to rounding, the equations do not determine the motion.
    Singular {
        /// The unknown that moves farthest in the motion that the equations leave free. Where no rates are asked for,
        /// or the pivot is zero to rounding, the unknown of its column, which says less.
        part: Part,
        /// The largest candidate for the pivot.
        pivot: T,
        /// The threshold that it must exceed.
        threshold: T,
    },
    /// The point is on the wrong side of the three points that links join it to: the lengths are kept, but the part
    /// that they form is the mirror image of the model's.
    Mirrored {
        /// The point, one of [`Linkage::linked`](crate::linkage::Linkage::linked).
        part: Part,
    },
    /// `step > bound`: near a root the first correction is a small part of the predicted move or of the linkage's size,
    /// and each later one is smaller than the one before. This unknown's is larger, so a root, if there is one, might
    /// belong to another assembly.
    Diverging {
        /// The unknown with the largest correction.
        part: Part,
        /// Its size, in units of length; for a bounded step the norm of all corrections.
        step: T,
        /// The bound that it must not exceed.
        bound: T,
    },
    /// `change > bound`: the Jacobian changes so much over the step that singularities may lie in between, possibly
    /// an even number of them.
    TooFar {
        /// The unknown with the largest change.
        part: Part,
        /// Its size, in units of length.
        change: T,
        /// The bound that it must not exceed: the size of the step times
        /// [`Tracker::change_of_jacobian`](crate::Tracker::change_of_jacobian), or what is small for the linkage's size.
        bound: T,
    },
    /// `step > bound`, both in the unit of time: the series of the motion is not valid for so long a step. This
    /// unknown has the largest last term of the series.
    StepTooLong {
        /// The unknown.
        part: Part,
        /// The length of the step.
        step: T,
        /// The bound that it must not exceed.
        bound: T,
    },
    /// The time step is NaN or infinite.
    StepNotFinite,
    /// The quantity that leads the motion turns before it meets its target: beyond its extreme
    /// value there is no configuration on this branch.
    TurningPoint {
        /// The unknown that moves most there.
        part: Part,
        /// The target, in the quantity's unit.
        asked: T,
        /// The quantity's extreme value.
        extreme: T,
    },
    /// A drive is an angle beyond its range, where the equations have the sine or cosine of another angle.
    OutOfRange {
        /// The drive.
        part: Part,
        /// The angle, radians.
        asked: T,
        /// The end of the range.
        end: T,
    },
    /// `residual > tolerance` after all permitted iterations.
    NotConverged {
        /// The equation with the largest residual.
        part: Part,
        /// Its size, in units of length; for a bounded step the norm of all residuals.
        residual: T,
        /// The tolerance that it must reach.
        tolerance: T,
        /// The number of iterations made; in a bounded step, of corrections.
        iterations: usize,
    },
}

impl<T> SolveError<T> {
    /// [`NotFinite`](Self::NotFinite) for an equation.
    pub(crate) fn not_finite(equation: usize) -> Self {
        let part = Part::Equation(equation);
        Self::NotFinite { part }
    }

    /// [`Overflow`](Self::Overflow) for an unknown.
    pub(crate) fn overflow(unknown: usize) -> Self {
        let part = Part::Unknown(unknown);
        Self::Overflow { part }
    }

    /// The error of a step of length `dt`, which is the cause if it is not finite.
    pub(crate) fn of_step(self, dt: T) -> Self
    where
        T: Real,
    {
        if dt.is_finite() {
            self
        } else {
            Self::StepNotFinite
        }
    }

    /// The equation, unknown, point or drive concerned; `None` if it is the time step.
    pub fn part(&self) -> Option<Part> {
        match *self {
            Self::StepNotFinite => None,
            Self::NotFinite { part }
            | Self::Overflow { part }
            | Self::CrossedSingularity { part }
            | Self::Singular { part, .. }
            | Self::Mirrored { part }
            | Self::Diverging { part, .. }
            | Self::TooFar { part, .. }
            | Self::StepTooLong { part, .. }
            | Self::TurningPoint { part, .. }
            | Self::OutOfRange { part, .. }
            | Self::NotConverged { part, .. } => Some(part),
        }
    }
}

impl<T: Real> SolveError<T> {
    fn cause(&self) -> Cause {
        match self {
            Self::NotFinite { .. } => Cause::NotFinite,
            Self::Overflow { .. } => Cause::Overflow,
            Self::CrossedSingularity { .. } => Cause::CrossedSingularity,
            Self::Singular { .. } => Cause::Singular,
            Self::Mirrored { .. } => Cause::Mirrored,
            Self::Diverging { .. } => Cause::Diverging,
            Self::TooFar { .. } => Cause::TooFar,
            Self::StepTooLong { .. } => Cause::StepTooLong,
            Self::StepNotFinite => Cause::StepNotFinite,
            Self::TurningPoint { .. } => Cause::TurningPoint,
            Self::OutOfRange { .. } => Cause::AngleOutOfRange,
            Self::NotConverged { .. } => Cause::NotConverged,
        }
    }

    /// The inequality that is not met, if the variant has its numbers.
    #[rustfmt::skip]
    fn compared(&self) -> Option<Compared> {
        let (what, value, relation, bound) = match *self {
            Self::NotFinite { .. }
            | Self::Overflow { .. }
            | Self::CrossedSingularity { .. }
            | Self::Mirrored { .. }
            | Self::StepNotFinite => return None,
            Self::Singular { pivot, threshold, .. } => ("pivot", pivot, "needed more than", threshold),
            Self::Diverging { step, bound, .. } => ("correction", step, "allowed", bound),
            Self::TooFar { change, bound, .. } => ("change", change, "allowed", bound),
            Self::StepTooLong { step, bound, .. } => ("step", step, "allowed", bound),
            Self::TurningPoint { asked, extreme, .. } => ("target", asked, "extreme value", extreme),
            Self::OutOfRange { asked, end, .. } => ("angle", asked, "end of its range", end),
            Self::NotConverged { residual, tolerance, .. } => ("residual", residual, "tolerance", tolerance),
        };
        Some(Compared::new(what, value, relation, bound))
    }
}

impl<T: Real> Explain for SolveError<T> {
    fn facts(&self) -> Facts {
        Facts {
            compared: self.compared(),
            ..Facts::new(self.cause(), self.part())
        }
    }
}
