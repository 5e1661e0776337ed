//! The report of a step, for all ways to step.

use crate::arithmetic::scalar::Real;

/// What a step did, or an advance in several steps. It keeps squares where a step computes them: most controllers
/// compute a root in software, so roots are taken only when they are read.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Report<T> {
    pub(crate) tolerance: T,
    pub(crate) residual_squared: T,
    pub(crate) error_squared: T,
    pub(crate) growth_squared: T,
    /// The number of steps made: one for a step, as many as it took for an advance.
    pub steps: usize,
    /// The number of factorisations made for the position, in all steps together.
    pub iterations: usize,
}

impl<T: Real> Report<T> {
    /// The residual left after the last step, in units of length. This is the largest residual. For a bounded step it
    /// is the norm of all, computed from the quadratic identity: the rounding errors of an evaluation, which may be
    /// far larger, are not in it. Without corrections it is the [`error`](Self::error), which bounds that norm.
    pub fn residual(&self) -> T {
        self.residual_squared.sqrt()
    }

    /// The tolerance with which the residual was compared, in units of length.
    pub fn tolerance(&self) -> T {
        self.tolerance
    }

    /// The size of the first correction of the last step, in units of length: the error of the predicted position.
    /// This is the largest entry; for a bounded step it is the norm.
    pub fn error(&self) -> T {
        self.error_squared.sqrt()
    }

    /// Pivot growth of the last factorisation: the norm of the inverses of the pivots. How far rounding errors grow
    /// with it, [`Factors::growth_squared`](crate::linkage::Factors::growth_squared) says.
    pub fn growth(&self) -> T {
        self.growth_squared.sqrt()
    }

    /// The report after one more step.
    pub(crate) fn with_next(self, next: Self) -> Self {
        Self {
            steps: self.steps + next.steps,
            iterations: self.iterations + next.iterations,
            ..next
        }
    }
}
