//! How small a pivot may be.

use crate::arithmetic::scalar::Real;

/// The [growth](crate::linkage::Factors::growth_squared) up to which the fixed order of elimination is used: the
/// rounding error there with one small pivot, as a multiple of the error with partial pivoting. At the instants of
/// the published motion it is 33 or less.
const GROWTH_LIMIT: f64 = 1e3;

/// The pivot, as a multiple of the square root of `EPSILON`, at which no digit of a velocity is known: a residual at
/// rounding level then leaves an error as large as that in the position.
const LEAST_PIVOT: f64 = 8.0;

/// The smallest pivot that determines a velocity.
pub(crate) fn least_pivot<T: Real>() -> T {
    T::EPSILON.sqrt() * T::constant(LEAST_PIVOT)
}

/// The largest [growth](crate::linkage::Factors::growth_squared) that is accepted, not squared.
pub(crate) fn growth_limit<T: Real>() -> T {
    T::constant(GROWTH_LIMIT).min(T::one() / least_pivot())
}

/// Whether pivots with this [growth](crate::linkage::Factors::growth_squared) are accepted.
pub(crate) fn is_healthy<T: Real>(growth_squared: T) -> bool {
    let limit = growth_limit::<T>();
    growth_squared < limit * limit
}
