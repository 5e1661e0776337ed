//! Newton's method: each correction is limited in size, and only the residual decides success.

use nalgebra::SVector;

use crate::arithmetic::magnitude::{index_of_largest, largest, magnitude};
use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::listing::Part;
use crate::signal::{ChassisMotion, Inputs};
use crate::solve::factored::with_factors;
use crate::solve::motion::Prescribed;
use crate::solve::report::Report;
use crate::solve::tolerance::Tolerance;

/// See [`Newton::tolerance`]: in 12,000 random geometries rounding left residuals of no more than 4.2 roundings.
const DEFAULT_TOLERANCE: f64 = 16.0;

/// Settings of the iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Newton<T> {
    /// The largest residual that is accepted as a root. Rounding is `EPSILON` times the size of the linkage or its
    /// largest coordinate, whichever is larger.
    pub tolerance: Tolerance<T>,
    /// The number of iterations allowed, 1 or more.
    pub max_iterations: usize,
    /// The largest ratio of a correction to the one before it; `None` accepts any.
    ///
    /// From a start where the Newton-Kantorovich condition holds, each correction is at most half of the one before
    /// (Deuflhard 2011, Newton Methods for Nonlinear Problems, section 2.1): a ratio of 1/2 stops early if there is
    /// no root near by. It does not by itself keep the solution in an assembly; [`Tracker`](crate::Tracker) also
    /// bounds the first correction.
    pub contraction: Option<T>,
    /// How often a correction may be halved until the residual falls; 0 is plain Newton.
    pub max_halvings: usize,
}

impl<T: Real> Newton<T> {
    /// Settings for a rough guess: many iterations, damped, any path.
    pub fn from_afar() -> Self {
        let tolerance = Tolerance::Roundings(T::constant(DEFAULT_TOLERANCE));
        Self {
            tolerance,
            max_iterations: 60,
            contraction: None,
            max_halvings: 20,
        }
    }

    /// Settings for a start near the root: few iterations, each correction at most half of the last.
    pub fn near_by() -> Self {
        let tolerance = Tolerance::Roundings(T::constant(DEFAULT_TOLERANCE));
        let contraction = Some(T::constant(0.5));
        Self {
            tolerance,
            max_iterations: 10,
            contraction,
            max_halvings: 0,
        }
    }

    /// Solves `F(q) = 0`, starting from `q`, and stores the root there.
    ///
    /// # Errors
    ///
    /// See [`SolveError`]; `q` is then unchanged.
    pub fn solve<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: &Inputs<C, L::Drives>,
        q: &mut SVector<T, N>,
    ) -> Result<Report<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let prescribed = Prescribed::new(linkage, inputs);
        self.solve_prescribed(linkage, &prescribed, q, None)
    }

    /// Whether `q` is a root by the test with which [`solve`](Self::solve) accepts one.
    pub fn is_root<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: &Inputs<C, L::Drives>,
        q: &SVector<T, N>,
    ) -> bool
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let Prescribed { fixed, drives } = Prescribed::new(linkage, inputs);
        let residual = linkage.residual(q, &fixed.value, &drives.value);
        magnitude(&residual).is_ok_and(|worst| worst <= self.tolerance_at(linkage, q))
    }

    /// As [`solve`](Self::solve), with prepared inputs and a bound on the first correction.
    pub(crate) fn solve_prescribed<L, const N: usize>(
        &self,
        linkage: &L,
        prescribed: &Prescribed<L::Fixed, L::Drives>,
        q: &mut SVector<T, N>,
        first_bound: Option<T>,
    ) -> Result<Report<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
    {
        let (fixed, drives) = (&prescribed.fixed.value, &prescribed.drives.value);
        let residual_at = |x: &SVector<T, N>| linkage.residual(x, fixed, drives);
        let mut at = Iterate::new(*q, residual_at(q))?;
        let mut bound = first_bound;
        let mut error = T::zero();
        for iterations in 1..=self.max_iterations {
            let (size, growth_squared, next) =
                self.iterated(linkage, fixed, &at, bound, residual_at)?;
            if iterations == 1 {
                error = size;
            }
            bound = self.contraction.map(|contraction| contraction * size);
            at = next;
            let tolerance = self.tolerance_at(linkage, &at.q);
            if at.worst <= tolerance {
                *q = at.q;
                return Ok(Report {
                    tolerance,
                    residual_squared: at.worst * at.worst,
                    error_squared: error * error,
                    growth_squared,
                    steps: 1,
                    iterations,
                });
            }
        }
        Err(SolveError::NotConverged {
            part: Part::Equation(index_of_largest(&at.residual)),
            residual: at.worst,
            tolerance: self.tolerance_at(linkage, &at.q),
            iterations: self.max_iterations,
        })
    }

    /// One iteration: the size of the correction, which must be within the bound, the pivot growth of the factors, squared,
    /// and the next iterate.
    fn iterated<L, const N: usize>(
        &self,
        linkage: &L,
        fixed: &L::Fixed,
        from: &Iterate<T, N>,
        bound: Option<T>,
        residual_at: impl Fn(&SVector<T, N>) -> SVector<T, N> + Copy,
    ) -> Result<(T, T, Iterate<T, N>), SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
    {
        with_factors(linkage, &from.q, fixed, T::zero(), |factors| {
            let step = factors.solve(&from.residual);
            let size = bounded_size(&step, bound, rounding_at(linkage, &from.q))?;
            let next = self.damped(from, &step, residual_at)?;
            let growth_squared = factors.growth_squared();
            if next.worst > self.tolerance_at(linkage, &next.q) {
                return Ok((size, growth_squared, next));
            }
            // One more correction with the same factors removes the error of second order that the last one has left.
            let better = next.q - factors.solve(&next.residual);
            Ok((size, growth_squared, next.better_of(better, residual_at)))
        })?
    }

    /// The largest residual that is accepted as a root at a position.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn tolerance_at<L, const N: usize>(&self, linkage: &L, q: &SVector<T, N>) -> T
    where
        L: Linkage<N, Scalar = T>,
    {
        self.tolerance.length(rounding_at(linkage, q))
    }

    /// The correction, halved until the residual falls at least a quarter as fast as its linear model does, or until
    /// no halving is left.
    fn damped<const N: usize>(
        &self,
        from: &Iterate<T, N>,
        step: &SVector<T, N>,
        residual_at: impl Fn(&SVector<T, N>) -> SVector<T, N>,
    ) -> Result<Iterate<T, N>, SolveError<T>> {
        let mut fraction = T::one();
        for _ in 0..self.max_halvings {
            let q = from.q - step * fraction;
            let residual = residual_at(&q);
            let bound = (T::one() - fraction * T::constant(0.25)) * from.residual.norm();
            if residual.norm() <= bound {
                return Iterate::new(q, residual);
            }
            fraction *= T::constant(0.5);
        }
        let q = from.q - step * fraction;
        Iterate::new(q, residual_at(&q))
    }
}

impl<T: Real> Default for Newton<T> {
    fn default() -> Self {
        Self::near_by()
    }
}

/// The rounding error of a length at a position.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn rounding_at<T, L, const N: usize>(linkage: &L, q: &SVector<T, N>) -> T
where
    T: Real,
    L: Linkage<N, Scalar = T>,
{
    let [coordinates] = q.data.0;
    T::EPSILON * linkage.size().max(largest(coordinates))
}

/// The size of a correction, which is refused if it exceeds its bound. Corrections of the size of rounding errors are
/// not bounded.
pub(crate) fn bounded_size<T: Real, const N: usize>(
    step: &SVector<T, N>,
    bound: Option<T>,
    rounding: T,
) -> Result<T, SolveError<T>> {
    let size = magnitude(step).map_err(SolveError::overflow)?;
    match bound.map(|bound| bound.max(rounding * T::constant(1024.0))) {
        Some(bound) if size > bound => Err(SolveError::Diverging {
            part: Part::Unknown(index_of_largest(step)),
            step: size,
            bound,
        }),
        _ => Ok(size),
    }
}

/// The unknowns on the way to a root, with their residual and its largest entry.
#[derive(Clone, Copy)]
struct Iterate<T, const N: usize> {
    q: SVector<T, N>,
    residual: SVector<T, N>,
    worst: T,
}

impl<T: Real, const N: usize> Iterate<T, N> {
    fn new(q: SVector<T, N>, residual: SVector<T, N>) -> Result<Self, SolveError<T>> {
        let worst = magnitude(&residual).map_err(SolveError::not_finite)?;
        Ok(Self { q, residual, worst })
    }

    /// The iterate itself, or that at `q` if its residual is smaller.
    fn better_of(
        self,
        q: SVector<T, N>,
        residual_at: impl Fn(&SVector<T, N>) -> SVector<T, N>,
    ) -> Self {
        match Self::new(q, residual_at(&q)) {
            Ok(better) if better.worst < self.worst => better,
            _ => self,
        }
    }
}
