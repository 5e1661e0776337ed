//! Values by name: points, drives, measures, lengths.

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
