//! A sum of coordinates that stays constant.

use crate::arithmetic::scalar::Scalar;

/// A sum of coordinates that keeps its design value `c`: `F = sum - c`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Held<T> {
    value: T,
}

impl<T: Scalar> Held<T> {
    /// A sum that keeps this value.
    #[inline]
    pub fn new(value: T) -> Self {
        Self { value }
    }

    /// `F`: the amount by which the sum is too large.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn residual(&self, sum: T) -> T {
        sum - self.value
    }

    /// The same constraint in another number type: see [`Listing::gather`](crate::linkage::Listing::gather).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gather<M, S: Scalar>(
        of: impl Fn(&M) -> Held<S>,
        number: &impl Fn(&dyn Fn(&M) -> S) -> T,
    ) -> Self {
        Self::new(number(&|model| of(model).value))
    }
}
