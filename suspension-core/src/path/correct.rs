//! The corrector: Newton's method on a curve.

use nalgebra::SVector;

use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::magnitude::{index_of_largest, magnitude};
use crate::newton::{Converged, Newton, within};
use crate::path::configuration::Configuration;
use crate::path::curve::Curve;
use crate::path::linear::of_entry;
use crate::scalar::Real;

impl<T: Real, L: Linkage<N, Scalar = T>, const N: usize> Curve<'_, L, N> {
    /// Newton's method with one entry held: the configuration near `start` that solves the
    /// equations. The first correction must stay within `bound`.
    pub(crate) fn correct(
        &self,
        newton: &Newton<T>,
        start: Configuration<T, N>,
        parameter: usize,
        first_bound: T,
    ) -> Result<(Configuration<T, N>, Converged<T>), SolveError<T>> {
        let mut at = start;
        let mut residual = self.residual(&at);
        let mut bound = Some(first_bound);
        let mut worst = finite(&residual)?;
        for iterations in 1..=newton.max_iterations {
            let linear = self.linear(&at, parameter)?;
            let rounding = newton.rounding_at(self.linkage, &at.unknowns);
            let step = linear.lu.solve(&residual);
            let size = within(&step, bound, rounding).map_err(of_entry::<T, N>(parameter))?;
            at = at - linear.along(&step);
            // One more correction with the same factors takes off what the square of the first
            // has left.
            let better = at - linear.along(&linear.lu.solve(&self.residual(&at)));
            let left = [self.residual(&at), self.residual(&better)];
            let [here, there] = [finite(&left[0])?, finite(&left[1])?];
            (worst, residual) = (here, left[0]);
            if there < here {
                (at, worst, residual) = (better, there, left[1]);
            }
            let tolerance = newton.tolerance_at(self.linkage, &at.unknowns);
            if worst <= tolerance {
                let converged = Converged {
                    iterations,
                    residual: worst,
                    tolerance,
                    growth: linear.growth(),
                };
                return Ok((at, converged));
            }
            bound = newton.contraction.map(|contraction| contraction * size);
        }
        Err(SolveError::NotConverged {
            equation: index_of_largest(&residual),
            residual: worst,
            tolerance: newton.tolerance_at(self.linkage, &at.unknowns),
            iterations: newton.max_iterations,
        })
    }
}

/// The largest residual; the equation of one that is not finite as the error.
pub(crate) fn finite<T: Real, const N: usize>(
    residual: &SVector<T, N>,
) -> Result<T, SolveError<T>> {
    magnitude(residual).map_err(|equation| SolveError::NotFinite { equation })
}
