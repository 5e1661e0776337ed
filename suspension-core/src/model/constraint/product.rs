//! Two lines at a constant angle.

use nalgebra::Vector3;

use crate::arithmetic::scalar::Scalar;
use crate::arithmetic::vector::{dot, multiple};

/// Two lines `d` and `e` of constant lengths that keep the cosine `c` of the angle between them:
/// `F = (d . e - c |d| |e|) / (|d| + |e|)`. Singular if the lines are parallel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Product<T> {
    cosine: T,
    lengths: [T; 2],
    /// `1 / (|d| + |e|)`.
    inverse: T,
}

impl<T: Scalar> Product<T> {
    /// Lines of these lengths, which must not be zero, with this cosine.
    #[inline]
    pub fn new(cosine: T, lengths: [T; 2]) -> Self {
        let [d, e] = lengths;
        Self {
            cosine,
            lengths,
            inverse: T::one() / (d + e),
        }
    }

    /// The cosine `c`.
    #[inline]
    pub fn cosine(&self) -> T {
        self.cosine
    }

    /// `F(d, e)`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn residual(&self, d: Vector3<T>, e: Vector3<T>) -> T {
        let [of_d, of_e] = self.lengths;
        dot(d, e).minus_product(self.cosine, of_d * of_e) * self.inverse
    }

    /// The derivative with respect to one line, from the other: `dF/dd = e / (|d| + |e|)`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gradient(&self, other: Vector3<T>) -> Vector3<T> {
        multiple(other, self.inverse)
    }

    /// `C(v, w)`, where `v` and `w` each hold the changes of both lines.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn curvature(&self, v: [Vector3<T>; 2], w: [Vector3<T>; 2]) -> T {
        let ([v_d, v_e], [w_d, w_e]) = (v, w);
        (dot(v_d, w_e) + dot(v_e, w_d)) * self.inverse
    }

    /// The same constraint in another number type: see [`Listing::gather`](crate::linkage::Listing::gather).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gather<M, S: Scalar>(
        of: impl Fn(&M) -> Product<S>,
        number: &impl Fn(&dyn Fn(&M) -> S) -> T,
    ) -> Self {
        // The inverse has all digits of the other number type, because it is part of the equation.
        let [d, e] = [
            number(&|model| {
                let [d, _] = of(model).lengths;
                d
            }),
            number(&|model| {
                let [_, e] = of(model).lengths;
                e
            }),
        ];
        Self::new(number(&|model| of(model).cosine), [d, e])
    }
}
