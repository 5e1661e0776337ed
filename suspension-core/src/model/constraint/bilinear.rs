//! A sum of products.

use crate::arithmetic::scalar::Scalar;

/// Products of lengths over a length `L`, and what is linear beside them: `F = l + sum u_k v_k / L`. A row that
/// defines an unknown has this in `l`, with the factor 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bilinear<T> {
    length: T,
    inverse: T,
}

impl<T: Scalar> Bilinear<T> {
    /// Products over a `length`, which must not be zero.
    #[inline]
    pub fn new(length: T) -> Self {
        Self {
            length,
            inverse: T::one() / length,
        }
    }

    /// The length `L`.
    #[inline]
    pub fn length(&self) -> T {
        self.length
    }

    /// `F`, from the linear part and the factors of each product.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn residual(&self, linear: T, products: impl IntoIterator<Item = (T, T)>) -> T {
        let products = products.into_iter();
        let sum = products.fold(T::zero(), |sum, (u, v)| sum.plus_product(u, v));
        linear.plus_product(sum, self.inverse)
    }

    /// The derivative by one variable, of all that it is multiplied with.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gradient(&self, others: impl IntoIterator<Item = T>) -> T {
        let others = others.into_iter();
        others.fold(T::zero(), |sum, other| sum + other) * self.inverse
    }

    /// `C(v, w)`, with the changes of the factors of each product: in `v`, then in `w`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn curvature(&self, products: impl IntoIterator<Item = [(T, T); 2]>) -> T {
        let products = products.into_iter();
        let sum = products.fold(T::zero(), |sum, [v, w]| {
            sum.plus_product(v.0, w.1).plus_product(w.0, v.1)
        });
        sum * self.inverse
    }

    /// The same in other numbers: see [`Listing::gather`](crate::linkage::Listing::gather).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gather<M, S: Scalar>(
        of: impl Fn(&M) -> Bilinear<S>,
        number: &impl Fn(&dyn Fn(&M) -> S) -> T,
    ) -> Self {
        // The inverse to all digits of the other number: it is part of the equation.
        Self::new(number(&|model| of(model).length))
    }
}
