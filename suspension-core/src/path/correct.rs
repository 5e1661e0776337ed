//! The corrector: Newton's method on a curve.

use nalgebra::SVector;

use crate::error::SolveError;
use crate::linkage::Factors as _;
use crate::linkage::Linkage;
use crate::listing::Part;
use crate::magnitude::{index_of_largest, magnitude};
use crate::newton::{Newton, rounding_at, within};
use crate::path::configuration::Configuration;
use crate::path::curve::Curve;
use crate::path::linear::of_drive;
use crate::report::Report;
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
    ) -> Result<(Configuration<T, N>, Report<T>), SolveError<T>> {
        let mut at = start;
        let mut residual = self.residual(&at);
        let mut bound = Some(first_bound);
        let mut worst = finite(&residual)?;
        let mut error = T::zero();
        for iterations in 1..=newton.max_iterations {
            let linear = self.linear(&at, parameter)?;
            let rounding = rounding_at(self.linkage, &at.unknowns);
            let step = linear.lu.solve(&residual);
            let size = within(&step, bound, rounding).map_err(of_drive(parameter, self.drive))?;
            if iterations == 1 {
                error = size;
            }
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
                let report = Report {
                    tolerance,
                    residual_squared: worst * worst,
                    error_squared: error * error,
                    growth_squared: linear.lu.growth_squared(),
                    steps: 1,
                    iterations,
                };
                return Ok((at, report));
            }
            bound = newton.contraction.map(|contraction| contraction * size);
        }
        Err(SolveError::NotConverged {
            part: Part::Equation(index_of_largest(&residual)),
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
    magnitude(residual).map_err(SolveError::not_finite)
}
