//! The largest of many numbers, and where it stands.

use nalgebra::SVector;

use crate::arithmetic::scalar::{Real, Scalar};

/// The largest magnitude; zero of an empty array. Runs four chains of comparisons side by side.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn largest<T: Real, const K: usize>(numbers: [T; K]) -> T {
    let mut largest = [T::zero(); 4];
    for (index, number) in numbers.into_iter().enumerate() {
        if let Some(chain) = largest.get_mut(index % 4) {
            *chain = chain.larger_magnitude(number);
        }
    }
    let [a, b, c, d] = largest;
    a.larger_magnitude(b)
        .larger_magnitude(c.larger_magnitude(d))
}

/// The sum of the squares, computed in four chains side by side. Propagates NaN.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn sum_of_squares<T: Scalar, const K: usize>(numbers: [T; K]) -> T {
    let mut sums = [T::zero(); 4];
    for (index, number) in numbers.into_iter().enumerate() {
        if let Some(chain) = sums.get_mut(index % 4) {
            *chain = chain.plus_product(number, number);
        }
    }
    let [a, b, c, d] = sums;
    (a + b) + (c + d)
}

/// The largest magnitude of the entries, or as the error the index of the first entry that is not finite.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn magnitude<T: Real, const N: usize>(vector: &SVector<T, N>) -> Result<T, usize> {
    // A number that is not finite times zero is NaN.
    let [entries] = vector.data.0;
    let finite = entries
        .iter()
        .fold(T::zero(), |sum, entry| sum + *entry * T::zero());
    if finite == T::zero() {
        Ok(largest(entries))
    } else {
        Err(entries
            .iter()
            .position(|entry| !entry.is_finite())
            .unwrap_or_default())
    }
}

/// The index of the entry with the largest magnitude.
#[cold]
pub(crate) fn index_of_largest<T: Real, const N: usize>(vector: &SVector<T, N>) -> usize {
    let mut best = (0, T::zero());
    for (index, entry) in vector.iter().enumerate() {
        if entry.abs() > best.1 {
            best = (index, entry.abs());
        }
    }
    best.0
}
