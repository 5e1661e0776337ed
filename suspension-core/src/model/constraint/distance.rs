//! Two points a constant length apart.

use nalgebra::Vector3;

use crate::arithmetic::scalar::Scalar;
use crate::arithmetic::vector::{dot, multiple};

/// A constant length `L` between two points: `F = (|d|^2 - L^2) / (2 L)`, where `d` is the vector from one to the
/// other. Attia 2003, eq. (1.1) to (1.14), divided by `2 L`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Distance<T> {
    length: T,
    inverse: T,
}

impl<T: Scalar> Distance<T> {
    /// A distance of `length`, which must not be zero.
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

    /// `F(d)`: to first order the amount by which `d` is too long.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn residual(&self, d: Vector3<T>) -> T {
        // The gradient is available wherever the equation is solved.
        (dot(d, self.gradient(d)) - self.length) * T::constant(0.5)
    }

    /// `dF/dd = d / L`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gradient(&self, d: Vector3<T>) -> Vector3<T> {
        multiple(d, self.inverse)
    }

    /// `C(v, w) = v . w / L`, where `v` and `w` are changes of `d`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn curvature(&self, v: Vector3<T>, w: Vector3<T>) -> T {
        dot(v, w) * self.inverse
    }

    /// The same constraint in another number type: see [`Listing::gather`](crate::linkage::Listing::gather).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gather<M, S: Scalar>(
        of: impl Fn(&M) -> Distance<S>,
        number: &impl Fn(&dyn Fn(&M) -> S) -> T,
    ) -> Self {
        // The inverse has all digits of the other number type, because it is part of the equation.
        Self::new(number(&|model| of(model).length))
    }
}
