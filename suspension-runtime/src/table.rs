//! Tables of a fixed capacity, read at indices that a plan holds.

use core::fmt::Debug;

use nalgebra::Vector3;
use suspension_core::{Scalar, Values};

/// The last place of any table: values that are not needed go there.
pub(crate) const SPARE: u16 = u16::MAX;

/// An index as plans store it. Listings are limited to far fewer of everything.
pub(crate) fn index(index: usize) -> u16 {
    u16::try_from(index).unwrap_or(SPARE)
}

/// A value that a table holds.
pub trait Value: Copy + Default + Debug + Send + Sync {}

impl<V: Copy + Default + Debug + Send + Sync> Value for V {}

/// A table with room for a fixed number of values; those that a listing does not fill keep their defaults.
pub trait Table<V: Value>: Value + Values<V> {
    /// The number of values that there is room for.
    const ROOM: usize;

    /// The value at an index; for an index beyond the table, the value of another place.
    fn get(&self, index: u16) -> V;

    /// The place of an index; for an index beyond the table, another place.
    fn place(&mut self, index: u16) -> &mut V;

    /// All places.
    fn as_slice(&self) -> &[V];

    /// All places.
    fn as_mut_slice(&mut self) -> &mut [V];
}

/// The values of `K` places, a power of two: an index is masked, which needs neither a branch nor a panic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Masked<V, const K: usize>([V; K]);

impl<V: Value, const K: usize> Default for Masked<V, K> {
    #[inline(always)]
    fn default() -> Self {
        const { assert!(K.is_power_of_two()) }
        Self([V::default(); K])
    }
}

impl<V: Value, const K: usize> Values<V> for Masked<V, K> {
    fn from_values(values: impl IntoIterator<Item = V>) -> Self {
        let mut table = Self::default();
        for (place, value) in table.0.iter_mut().zip(values) {
            *place = value;
        }
        table
    }

    fn values(&self) -> impl Iterator<Item = V> {
        self.0.iter().copied()
    }
}

impl<V: Value, const K: usize> Table<V> for Masked<V, K> {
    const ROOM: usize = K;

    #[inline(always)]
    #[allow(clippy::indexing_slicing, reason = "a masked index is in the table")]
    fn get(&self, index: u16) -> V {
        self.0[usize::from(index) & (K - 1)]
    }

    #[inline(always)]
    #[allow(clippy::indexing_slicing, reason = "a masked index is in the table")]
    fn place(&mut self, index: u16) -> &mut V {
        &mut self.0[usize::from(index) & (K - 1)]
    }

    #[inline(always)]
    fn as_slice(&self) -> &[V] {
        &self.0
    }

    #[inline(always)]
    fn as_mut_slice(&mut self) -> &mut [V] {
        &mut self.0
    }
}

/// Writes a value into a row, or an unknown into its place.
#[inline(always)]
pub(crate) fn put<T>(rows: &mut [T], row: u16, value: T) {
    if let Some(place) = rows.get_mut(usize::from(row)) {
        *place = value;
    }
}

#[inline(always)]
pub(crate) fn put_three<T: Scalar>(rows: &mut [T], first: u16, value: Vector3<T>) {
    let first = usize::from(first);
    if let Some([x, y, z]) = rows.get_mut(first..first + 3) {
        (*x, *y, *z) = (value.x, value.y, value.z);
    }
}

/// Writes the sum of terms, if there are any.
#[inline(always)]
pub(crate) fn put_sum<T: Scalar>(rows: &mut [T], row: u16, terms: impl Iterator<Item = T>) {
    if let Some(sum) = terms.reduce(|sum, term| sum + term) {
        put(rows, row, sum);
    }
}
