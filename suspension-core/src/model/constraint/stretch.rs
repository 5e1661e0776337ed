//! Two points a variable length apart.

use nalgebra::Vector3;

use crate::arithmetic::scalar::Scalar;
use crate::arithmetic::vector::{dot, multiple};
use crate::model::constraint::square_root;

/// An unknown length `s` between two points: `F = (|d|^2 - s^2) / (2 L)`, where `d` is the vector from one to the
/// other and `L` the length in the design. A negative `s` acts as its magnitude.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stretch<T> {
    length: T,
    inverse: T,
}

impl<T: Scalar> Stretch<T> {
    /// Two points that are `length` apart in the design, which must not be zero.
    #[inline]
    pub fn new(length: T) -> Self {
        Self {
            length,
            inverse: T::one() / length,
        }
    }

    /// The length `L` in the design.
    #[inline]
    pub fn length(&self) -> T {
        self.length
    }

    /// `|d|`, exact to rounding between a quarter of `L` and four times `L`.
    #[inline]
    pub fn reach(&self, d: Vector3<T>) -> T {
        square_root::<6, _>(dot(d, d), self.length)
    }

    /// `F(d, s)`: to first order the amount by which `d` is too long, near the design.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn residual(&self, d: Vector3<T>, length: T) -> T {
        dot(d, d).minus_product(length, length) * self.inverse * T::constant(0.5)
    }

    /// `dF/dd = d / L`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gradient(&self, d: Vector3<T>) -> Vector3<T> {
        multiple(d, self.inverse)
    }

    /// `dF/ds = -s / L`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn by_length(&self, length: T) -> T {
        -(length * self.inverse)
    }

    /// `C(v, w)`, where `v` and `w` each hold the changes of `d` and of `s`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn curvature(&self, v: (Vector3<T>, T), w: (Vector3<T>, T)) -> T {
        dot(v.0, w.0).minus_product(v.1, w.1) * self.inverse
    }

    /// The same constraint in another number type: see [`Listing::gather`](crate::linkage::Listing::gather).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gather<M, S: Scalar>(
        of: impl Fn(&M) -> Stretch<S>,
        number: &impl Fn(&dyn Fn(&M) -> S) -> T,
    ) -> Self {
        // The inverse has all digits of the other number type, because it is part of the equation.
        Self::new(number(&|model| of(model).length))
    }
}
