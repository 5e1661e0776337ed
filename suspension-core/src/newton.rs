//! Bounded Newton iteration whose success is claimed only from the residual.

use nalgebra::SVector;

use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::lu::Lu;
use crate::motion::Prescribed;
use crate::scalar::Real;
use crate::signal::{ChassisMotion, Inputs};

/// How to iterate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Newton<T> {
    /// The largest residual that counts as a root, as a multiple of rounding: it is compared
    /// with `tolerance * EPSILON * max(size of the linkage, largest coordinate)`.
    pub tolerance: T,
    /// Iterations allowed.
    pub max_iterations: usize,
    /// The largest ratio of a correction to the one before it; `None` accepts any.
    ///
    /// From a start where the Newton-Kantorovich condition holds each correction is at most half
    /// of the one before, so a ratio of 1/2 refuses roots of other assemblies (Deuflhard 2011,
    /// Newton Methods for Nonlinear Problems, section 2.1).
    pub contraction: Option<T>,
}

/// What a successful iteration did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Converged<T> {
    /// Factorisations made.
    pub iterations: usize,
    /// The largest residual of the result, in units of length.
    pub residual: T,
    /// What it was compared with.
    pub tolerance: T,
}

impl<T: Real> Newton<T> {
    /// From a rough guess: many iterations, any path.
    pub fn from_afar() -> Self {
        Self {
            tolerance: T::constant(8.0),
            max_iterations: 50,
            contraction: None,
        }
    }

    /// From a start near the root: few iterations, each correction at most half of the last.
    pub fn near_by() -> Self {
        Self {
            tolerance: T::constant(8.0),
            max_iterations: 10,
            contraction: Some(T::constant(0.5)),
        }
    }

    /// Solves `F(q) = 0`, starting from `q` and leaving the root there.
    ///
    /// # Errors
    ///
    /// See [`SolveError`]; `q` is then unchanged.
    pub fn solve<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: &Inputs<C, L::Drives>,
        q: &mut SVector<T, N>,
    ) -> Result<Converged<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let prescribed = Prescribed::new(linkage, inputs);
        self.solve_prescribed(linkage, &prescribed, q)
    }

    pub(crate) fn solve_prescribed<L, const N: usize>(
        &self,
        linkage: &L,
        prescribed: &Prescribed<L::Fixed, L::Drives>,
        q: &mut SVector<T, N>,
    ) -> Result<Converged<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
    {
        let (fixed, drives) = (&prescribed.fixed.value, &prescribed.drives.value);
        let mut x = *q;
        let mut residual = linkage.residual(&x, fixed, drives);
        let mut worst = largest(&residual)?;
        let mut last_step = None;
        let mut tolerance = T::zero();
        for iterations in 1..=self.max_iterations {
            let lu = Lu::factor(&linkage.jacobian(&x, fixed))?;
            let step = lu.solve(&residual);
            let rounding = T::EPSILON * linkage.size().max(x.amax());
            last_step = Some(self.contracting(&step, last_step, rounding)?);
            tolerance = self.tolerance * rounding;
            x -= step;
            residual = linkage.residual(&x, fixed, drives);
            worst = largest(&residual)?;
            if worst.1 <= tolerance {
                // One more correction with the same factors takes off what the square of the
                // step has left. It is kept only where the residual agrees.
                let polished = x - lu.solve(&residual);
                let polished_worst = largest(&linkage.residual(&polished, fixed, drives))?;
                let better = polished_worst.1 < worst.1;
                *q = if better { polished } else { x };
                let residual = if better { polished_worst.1 } else { worst.1 };
                return Ok(Converged {
                    iterations,
                    residual,
                    tolerance,
                });
            }
        }
        let (equation, residual) = worst;
        Err(SolveError::NotConverged {
            equation,
            residual,
            tolerance,
            iterations: self.max_iterations,
        })
    }

    /// Checks that a correction is small enough beside the one before it, and returns its size.
    fn contracting<const N: usize>(
        &self,
        step: &SVector<T, N>,
        last_step: Option<T>,
        rounding: T,
    ) -> Result<T, SolveError<T>> {
        let (unknown, size) = largest(step)?;
        if let (Some(contraction), Some(last)) = (self.contraction, last_step) {
            // Corrections of the size of rounding errors need not shrink.
            let bound = (contraction * last).max(rounding * T::constant(1024.0));
            if !(size <= bound) {
                return Err(SolveError::Diverging {
                    unknown,
                    step: size,
                    bound,
                });
            }
        }
        Ok(size)
    }
}

impl<T: Real> Default for Newton<T> {
    fn default() -> Self {
        Self::near_by()
    }
}

/// Index and size of the entry with the largest magnitude.
fn largest<T: Real, const N: usize>(vector: &SVector<T, N>) -> Result<(usize, T), SolveError<T>> {
    let mut best = (0, T::zero());
    for (index, entry) in vector.iter().enumerate() {
        if !entry.is_finite() {
            return Err(SolveError::NotFinite { equation: index });
        }
        if entry.abs() > best.1 {
            best = (index, entry.abs());
        }
    }
    Ok(best)
}
