//! The report of a step, for all ways to step.

use crate::arithmetic::scalar::Real;

/// What a step did, or an advance in several. It keeps squares where a step computes them: a root is
/// software on most controllers, and taken only where it is read.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Report<T> {
    pub(crate) tolerance: T,
    pub(crate) residual_squared: T,
    pub(crate) error_squared: T,
    pub(crate) growth_squared: T,
    /// Steps made: one, or of an advance as many as it took.
    pub steps: usize,
    /// Factorisations made for the position, in all steps together.
    pub iterations: usize,
}

impl<T: Real> Report<T> {
    /// The residual that is left after the last step, in units of length: the largest, of a bounded
    /// step the norm of all, from the quadratic identity (far below what rounding leaves; without corrections
    /// a bound of it, the error).
    pub fn residual(&self) -> T {
        self.residual_squared.sqrt()
    }

    /// What the residual was compared with, in units of length.
    pub fn tolerance(&self) -> T {
        self.tolerance
    }

    /// The size of the first correction of the last step, in units of length: the error of the
    /// predicted position. The largest entry, of a bounded step the norm.
    pub fn error(&self) -> T {
        self.error_squared.sqrt()
    }

    /// Pivot growth: the norm of the inverses of the last pivots. Rounding errors grow with it, at most.
    pub fn growth(&self) -> T {
        self.growth_squared.sqrt()
    }

    /// The report of one step more.
    pub(crate) fn and(self, next: Self) -> Self {
        Self {
            steps: self.steps + next.steps,
            iterations: self.iterations + next.iterations,
            ..next
        }
    }
}
