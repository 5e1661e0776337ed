//! A factored Jacobian: in the macro's order of pivots, or where that is unhealthy, with partial
//! pivoting.

use nalgebra::SVector;

use crate::error::SolveError;
use crate::linkage::{Factors, Linkage};
use crate::lu::Lu;
use crate::scalar::Real;

/// The [growth](Factors::growth_squared) up to which the fixed order is used: what rounding costs there with
/// one small pivot, as a multiple of what it costs with partial pivoting. At the instants of the published
/// motion it is 33 or less.
const GROWTH_LIMIT: f64 = 1e3;

/// A pivot, as a multiple of the square root of `EPSILON`, at which no digit of a velocity is
/// known: a residual at rounding level leaves the position off by as much there.
const SMALLEST_PIVOT: f64 = 8.0;

/// The smallest pivot that determines a velocity.
pub(crate) fn smallest_pivot<T: Real>() -> T {
    T::EPSILON.sqrt() * T::constant(SMALLEST_PIVOT)
}

/// The largest [growth](Factors::growth_squared) that will do, not squared.
pub(crate) fn growth_limit<T: Real>() -> T {
    T::constant(GROWTH_LIMIT).min(T::one() / smallest_pivot())
}

/// Whether pivots with this [growth](Factors::growth_squared) will do.
pub(crate) fn is_healthy<T: Real>(growth_squared: T) -> bool {
    let limit = growth_limit::<T>();
    growth_squared < limit * limit
}

/// Gives `work` the factors of a linkage's Jacobian, whose pivots must exceed `threshold`.
///
/// # Errors
///
/// [`SolveError::Singular`] from partial pivoting, [`SolveError::NotFinite`] where an entry of the
/// Jacobian is not finite.
#[inline(always)]
pub fn with_factors<T, L, R, const N: usize>(
    linkage: &L,
    q: &SVector<T, N>,
    fixed: &L::Fixed,
    threshold: T,
    work: impl FnOnce(&dyn Factors<T, N>) -> R,
) -> Result<R, SolveError<T>>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
{
    let factors = linkage.factor(q, fixed);
    if is_healthy(factors.growth_squared()) {
        Ok(work(&factors))
    } else {
        Ok(work(&with_pivoting(linkage, q, fixed, threshold)?))
    }
}

#[cold]
#[inline(never)]
pub(crate) fn with_pivoting<T, L, const N: usize>(
    linkage: &L,
    q: &SVector<T, N>,
    fixed: &L::Fixed,
    threshold: T,
) -> Result<Lu<T, N>, SolveError<T>>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
{
    let mut lu = Lu::of(linkage.jacobian(q, fixed));
    lu.eliminate_jacobian(threshold)?;
    Ok(lu)
}

/// The factors of a Jacobian, to keep.
#[derive(Clone, Copy, Debug)]
pub enum Factored<F, T, const N: usize> {
    /// In the macro's order.
    InFixedOrder(F),
    /// With partial pivoting, because the pivots of the macro's order are unhealthy.
    WithPivoting(Lu<T, N>),
}

impl<T: Real, F: Factors<T, N>, const N: usize> Factored<F, T, N> {
    /// Factors the Jacobian of a linkage, for velocities.
    ///
    /// # Errors
    ///
    /// [`SolveError::Singular`] where a pivot is not above 8 times the square root of `EPSILON`,
    /// [`SolveError::NotFinite`] where an entry of the Jacobian is not finite.
    pub fn new<L>(linkage: &L, q: &SVector<T, N>, fixed: &L::Fixed) -> Result<Self, SolveError<T>>
    where
        L: Linkage<N, Scalar = T, Factors = F>,
    {
        let factors = linkage.factor(q, fixed);
        if is_healthy(factors.growth_squared()) {
            Ok(Self::InFixedOrder(factors))
        } else {
            with_pivoting(linkage, q, fixed, smallest_pivot()).map(Self::WithPivoting)
        }
    }

    /// The factors, whichever they are.
    pub fn factors(&self) -> &dyn Factors<T, N> {
        match self {
            Self::InFixedOrder(factors) => factors,
            Self::WithPivoting(lu) => lu,
        }
    }
}
