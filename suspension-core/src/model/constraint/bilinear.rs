//! A sum of products.

use crate::arithmetic::scalar::Scalar;

/// Products of lengths over a length `L`, and a linear part `l`: `F = l + sum u_k v_k / L`. In a row that defines an
/// unknown, the unknown is in `l`, with the factor 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bilinear<T> {
    length: T,
    inverse: T,
}

impl<T: Scalar> Bilinear<T> {
    /// Products over this `length`, which must not be zero.
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

    /// The derivative with respect to one variable, from all the factors that multiply it.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gradient(&self, others: impl IntoIterator<Item = T>) -> T {
        let others = others.into_iter();
        others.fold(T::zero(), |sum, other| sum + other) * self.inverse
    }

    /// `C(v, w)`, from the changes of both factors of each product, in `v` and then in `w`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn curvature(&self, products: impl IntoIterator<Item = [(T, T); 2]>) -> T {
        let products = products.into_iter();
        let sum = products.fold(T::zero(), |sum, [v, w]| {
            sum.plus_product(v.0, w.1).plus_product(w.0, v.1)
        });
        sum * self.inverse
    }

    /// The same constraint in another number type: see [`Listing::gather`](crate::linkage::Listing::gather).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gather<M, S: Scalar>(
        of: impl Fn(&M) -> Bilinear<S>,
        number: &impl Fn(&dyn Fn(&M) -> S) -> T,
    ) -> Self {
        // The inverse has all digits of the other number type, because it is part of the equation.
        Self::new(number(&|model| of(model).length))
    }
}
