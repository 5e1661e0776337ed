//! A factored Jacobian: in the macro's order of pivots or, if that is unhealthy, with partial
//! pivoting.

use nalgebra::SVector;

use crate::arithmetic::magnitude::index_of_largest;
use crate::arithmetic::pivot::{is_healthy, least_pivot};
use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::{Factors, Linkage};
use crate::listing::Part;
use crate::solve::lu::Lu;

/// The fraction of itself by which the Jacobian's smallest singular value may change within the rounding errors of
/// the position. At a lock, where the value would be zero without rounding, a residual of `k` roundings makes this
/// fraction `1 / (2 k)`: `1 / 32` for the largest residual that [`Newton`](crate::Newton) accepts by default.
const CHANGE_BY_ROUNDING: f64 = 1.0 / 64.0;

/// Passes to `work` the factors of a linkage's Jacobian, whose pivots must exceed `threshold`.
///
/// # Errors
///
/// [`SolveError::Singular`] from partial pivoting, [`SolveError::NotFinite`] if an entry of the Jacobian is not
/// finite.
#[cfg_attr(not(debug_assertions), inline(always))]
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

/// As [`with_factors`], for rates. They have no value at a singularity and are refused where hardly a digit of them
/// is known.
///
/// # Errors
///
/// As [`with_factors`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn with_factors_for_rates<T, L, R, const N: usize>(
    linkage: &L,
    q: &SVector<T, N>,
    fixed: &L::Fixed,
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
        with_pivoting_for_rates(linkage, q, fixed, |lu| work(lu))
    }
}

/// The factors with partial pivoting, whose pivots must exceed `threshold`.
///
/// # Errors
///
/// As [`with_factors`].
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
    let mut lu = Lu::unfactored(linkage.jacobian(q, fixed));
    lu.eliminate_jacobian(threshold)?;
    Ok(lu)
}

/// Passes to `work` the factors with partial pivoting, for rates. (Returned, they would lie on the stack twice.)
///
/// # Errors
///
/// As [`with_factors_for_rates`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn with_pivoting_for_rates<T, L, R, const N: usize>(
    linkage: &L,
    q: &SVector<T, N>,
    fixed: &L::Fixed,
    work: impl FnOnce(&Lu<T, N>) -> R,
) -> Result<R, SolveError<T>>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
{
    // Pivots that are zero to rounding are refused here, by their column; small ones are tested with the rest, where the
    // unknown that moves farthest is known.
    let lu = with_pivoting(linkage, q, fixed, T::zero())?;
    check_rates(linkage, &lu)?;
    Ok(work(&lu))
}

/// The direction of the unknowns that changes the equations least: the inverse takes almost any vector to it.
#[cold]
#[inline(never)]
fn least_determined<T: Real, const N: usize>(factors: &Lu<T, N>) -> SVector<T, N> {
    let any = SVector::from_fn(|row, _| T::one() / T::constant((row + 1) as f64));
    let direction = factors.solve(&any);
    direction / direction.norm()
}

/// Refuses factors near a lock, by the fraction of itself by which the smallest singular value may change within the
/// rounding errors of the position. Rates may be off by the same fraction.
#[cold]
#[inline(never)]
fn check_rates<T, L, const N: usize>(linkage: &L, factors: &Lu<T, N>) -> Result<(), SolveError<T>>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
{
    let direction = least_determined(factors);
    // The column of the smallest pivot says little of where a mechanism locks, because a singularity of any part shows in
    // the last pivots.
    let part = Part::Unknown(index_of_largest(&direction));
    let still = L::Fixed::default();
    let curvature = linkage.curvature(&direction, &still, &direction, &still);
    let change = factors.solve(&curvature).norm();
    let rounding = T::EPSILON * linkage.size();
    let by_rounding = change * change * rounding / curvature.norm();
    let most = T::constant(CHANGE_BY_ROUNDING);
    let pivot = factors.smallest_pivot();
    let least = least_pivot();
    if by_rounding > most || pivot <= least {
        return Err(SolveError::Singular {
            part,
            pivot,
            threshold: least.max(pivot * (by_rounding / most).sqrt()),
        });
    }
    Ok(())
}

/// The factors of a Jacobian, to keep.
#[derive(Clone, Copy, Debug)]
pub enum Factored<F, T, const N: usize> {
    /// Factors in the macro's order.
    InFixedOrder(F),
    /// Factors with partial pivoting, because the pivots of the macro's order are unhealthy.
    WithPivoting(Lu<T, N>),
}

impl<T: Real, F: Factors<T, N>, const N: usize> Factored<F, T, N> {
    /// Factors the Jacobian of a linkage, for velocities.
    ///
    /// # Errors
    ///
    /// [`SolveError::Singular`] if the rounding errors of the position leave hardly a digit of a velocity,
    /// [`SolveError::NotFinite`] if an entry of the Jacobian is not finite.
    pub fn new<L>(linkage: &L, q: &SVector<T, N>, fixed: &L::Fixed) -> Result<Self, SolveError<T>>
    where
        L: Linkage<N, Scalar = T, Factors = F>,
    {
        let factors = linkage.factor(q, fixed);
        if is_healthy(factors.growth_squared()) {
            Ok(Self::InFixedOrder(factors))
        } else {
            with_pivoting_for_rates(linkage, q, fixed, |lu| Self::WithPivoting(*lu))
        }
    }

    /// The factors, of either kind.
    pub fn factors(&self) -> &dyn Factors<T, N> {
        match self {
            Self::InFixedOrder(factors) => factors,
            Self::WithPivoting(lu) => lu,
        }
    }
}
