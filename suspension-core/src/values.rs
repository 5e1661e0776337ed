//! Values by name: points, drives, measures, lengths.

use nalgebra::Vector3;

use crate::arithmetic::scalar::Scalar;
use crate::arithmetic::vector::gather_vector;

/// A fixed number of values in a known order: points, drives, measures or lengths of a linkage.
///
/// There may be room for more values than a model has; those beyond are zero. The model tells what each value is:
/// [`Parts::name`](crate::listing::Parts::name), [`Parts::count`](crate::listing::Parts::count).
pub trait Values<V>: Copy {
    /// Takes as many values as there is room for, and uses defaults when they run out.
    fn from_values(values: impl IntoIterator<Item = V>) -> Self
    where
        V: Default;

    /// The values in order.
    fn values(&self) -> impl Iterator<Item = V>;

    /// The values with these indices, defaults beyond the last.
    #[inline]
    fn at<const K: usize>(&self, indices: [usize; K]) -> [V; K]
    where
        V: Default,
    {
        indices.map(|index| self.values().nth(index).unwrap_or_default())
    }

    /// Other values in the same order.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn map(&self, value: impl Fn(V) -> V) -> Self
    where
        V: Default,
    {
        Self::from_values(self.values().map(value))
    }

    /// The same values except the one with this index, which is replaced; unchanged for an index beyond the last.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn with(&self, index: usize, value: V) -> Self
    where
        V: Copy + Default,
    {
        let each = self.values().enumerate();
        Self::from_values(each.map(|(at, kept)| if at == index { value } else { kept }))
    }

    /// The values combined with others, pair by pair.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn combined(&self, others: &Self, combine: impl Fn(V, V) -> V) -> Self
    where
        V: Default,
    {
        let pairs = self.values().zip(others.values());
        Self::from_values(pairs.map(|(a, b)| combine(a, b)))
    }
}

/// Values that are the fields of a struct which `linkage!` writes. Code for any linkage asks the model for names
/// instead.
pub trait Named<V>: Values<V> {
    /// The fields' names, in order.
    const NAMES: &'static [&'static str];

    /// Fills each field from its name.
    fn from_fn(value: impl FnMut(&'static str) -> V) -> Self;
}

/// Vectors in another number type: see [`Listing::gather`](crate::linkage::Listing::gather).
#[doc(hidden)]
pub fn gather_vectors<M, V, W, S: Scalar, T: Scalar>(
    of: impl Fn(&M) -> V,
    number: &impl Fn(&dyn Fn(&M) -> S) -> T,
) -> W
where
    V: Values<Vector3<S>>,
    W: Values<Vector3<T>>,
{
    let vector = |model: &M, index| of(model).values().nth(index).unwrap_or_default();
    let vectors = (0..).map(|index| gather_vector(|model| vector(model, index), number));
    W::from_values(vectors)
}
