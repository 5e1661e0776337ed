//! The corrector: Newton's method on a curve.

use nalgebra::SVector;

use crate::arithmetic::magnitude::{index_of_largest, magnitude};
use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::listing::Part;
use crate::path::configuration::Configuration;
use crate::path::curve::Curve;
use crate::path::linear::{Linear, name_free_drive};
use crate::solve::newton::{Newton, bounded_size, rounding_at};
use crate::solve::report::Report;

/// The number of corrections with the same factors after the first with them. Each reduces the error by the same
/// ratio as the first, at a fraction of the cost of new factors.
const FURTHER: usize = 4;

impl<T: Real, L: Linkage<N, Scalar = T>, const N: usize> Curve<'_, L, N> {
    /// Newton's method with one entry held: finds the configuration near `start` that solves the equations. The first
    /// correction must not exceed `bound`.
    pub(crate) fn correct(
        &self,
        newton: &Newton<T>,
        start: Configuration<T, N>,
        parameter: usize,
        first_bound: T,
    ) -> Result<(Configuration<T, N>, Report<T>), SolveError<T>> {
        let mut iterate = Iterate::new(self, start)?;
        let mut bound = Some(first_bound);
        let mut error = T::zero();
        for iterations in 1..=newton.max_iterations {
            let linear = self.linear(&iterate.at, parameter)?;
            let rounding = rounding_at(self.linkage, &iterate.at.unknowns);
            let step = linear.solve(&iterate.residual);
            // The drive's correction is stored in the entry that is held.
            let corrections = step.with_entry(parameter, step.drive).unknowns;
            let size = bounded_size(&corrections, bound, rounding)
                .map_err(name_free_drive(parameter, self.drive))?;
            if iterations == 1 {
                error = size;
            }
            iterate = Iterate::new(self, iterate.at - step)?;
            let tolerance = newton.tolerance_at(self.linkage, &iterate.at.unknowns);
            iterate = self.corrected_further(iterate, &linear, tolerance)?;
            let Iterate { at, worst, .. } = iterate;
            if worst <= tolerance {
                let report = Report {
                    tolerance,
                    residual_squared: worst * worst,
                    error_squared: error * error,
                    growth_squared: linear.growth_squared(),
                    steps: 1,
                    iterations,
                };
                return Ok((at, report));
            }
            bound = newton.contraction.map(|contraction| contraction * size);
        }
        Err(SolveError::NotConverged {
            part: Part::Equation(index_of_largest(&iterate.residual)),
            residual: iterate.worst,
            tolerance: newton.tolerance_at(self.linkage, &iterate.at.unknowns),
            iterations: newton.max_iterations,
        })
    }

    /// Makes corrections with the same factors as long as they reduce the residual. The last one starts from within
    /// the tolerance.
    fn corrected_further(
        &self,
        mut iterate: Iterate<T, N>,
        linear: &Linear<L, N>,
        tolerance: T,
    ) -> Result<Iterate<T, N>, SolveError<T>> {
        for _ in 0..FURTHER {
            let next = Iterate::new(self, iterate.at - linear.solve(&iterate.residual))?;
            let is_last = iterate.worst <= tolerance || next.worst >= iterate.worst;
            if next.worst < iterate.worst {
                iterate = next;
            }
            if is_last {
                break;
            }
        }
        Ok(iterate)
    }
}

/// A configuration on the way, with its residual and the residual's largest entry.
#[derive(Clone, Copy)]
struct Iterate<T, const N: usize> {
    at: Configuration<T, N>,
    residual: SVector<T, N>,
    worst: T,
}

impl<T: Real, const N: usize> Iterate<T, N> {
    fn new<L: Linkage<N, Scalar = T>>(
        curve: &Curve<'_, L, N>,
        at: Configuration<T, N>,
    ) -> Result<Self, SolveError<T>> {
        let residual = curve.residual(&at);
        Ok(Self {
            at,
            residual,
            worst: finite(&residual)?,
        })
    }
}

/// The largest residual, or as the error the equation of a residual that is not finite.
pub(crate) fn finite<T: Real, const N: usize>(
    residual: &SVector<T, N>,
) -> Result<T, SolveError<T>> {
    magnitude(residual).map_err(SolveError::not_finite)
}
