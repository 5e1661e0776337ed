//! Tables of a fixed capacity, read at indices that a plan holds.

use core::fmt::Debug;

/// What tables hold.
pub trait Value: Copy + Debug + Send + Sync {}

impl<V: Copy + Debug + Send + Sync> Value for V {}

/// A table with room for a fixed number of values. What a listing does not fill keeps the value it was
/// made with.
pub trait Table<V>: Value {
    /// A table with the same value everywhere.
    fn filled(value: V) -> Self;

    /// The value at an index; of one beyond the table that of another place.
    fn get(&self, index: u16) -> V;

    /// The place of an index; of one beyond the table another place.
    fn place(&mut self, index: u16) -> &mut V;

    /// All places.
    fn as_slice(&self) -> &[V];

    /// All places.
    fn as_mut_slice(&mut self) -> &mut [V];
}

/// A table of `K` values, a power of two: an index is masked, which takes neither a branch nor a panic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Masked<V, const K: usize>([V; K]);

impl<V: Value, const K: usize> Table<V> for Masked<V, K> {
    #[inline(always)]
    fn filled(value: V) -> Self {
        const { assert!(K.is_power_of_two()) }
        Self([value; K])
    }

    #[inline(always)]
    #[allow(clippy::indexing_slicing)]
    fn get(&self, index: u16) -> V {
        self.0[usize::from(index) & (K - 1)]
    }

    #[inline(always)]
    #[allow(clippy::indexing_slicing)]
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
