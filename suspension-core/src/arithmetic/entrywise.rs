//! Arithmetic of vectors of unknowns, entry by entry and always inlined: see
//! [`vector`](crate::arithmetic::vector).

use nalgebra::SVector;

use crate::arithmetic::scalar::Scalar;

#[cfg_attr(not(debug_assertions), inline(always))]
fn zip<T: Scalar, const N: usize>(
    a: &SVector<T, N>,
    b: &SVector<T, N>,
    combine: impl Fn(T, T) -> T,
) -> SVector<T, N> {
    let ([mut result], [b]) = (a.data.0, &b.data.0);
    for (entry, b) in result.iter_mut().zip(b) {
        *entry = combine(*entry, *b);
    }
    SVector::from(result)
}

/// `a + b`.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn sum<T: Scalar, const N: usize>(
    a: &SVector<T, N>,
    b: &SVector<T, N>,
) -> SVector<T, N> {
    zip(a, b, |a, b| a + b)
}

/// `a - b`.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn difference<T: Scalar, const N: usize>(
    a: &SVector<T, N>,
    b: &SVector<T, N>,
) -> SVector<T, N> {
    zip(a, b, |a, b| a - b)
}

/// `a k`.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn multiple<T: Scalar, const N: usize>(a: &SVector<T, N>, k: T) -> SVector<T, N> {
    zip(a, a, |a, _| a * k)
}

/// `a + b k`.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn plus_multiple<T: Scalar, const N: usize>(
    a: &SVector<T, N>,
    b: &SVector<T, N>,
    k: T,
) -> SVector<T, N> {
    zip(a, b, |a, b| a.plus_product(b, k))
}

/// `a - b k`.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn minus_multiple<T: Scalar, const N: usize>(
    a: &SVector<T, N>,
    b: &SVector<T, N>,
    k: T,
) -> SVector<T, N> {
    zip(a, b, |a, b| a.minus_product(b, k))
}
