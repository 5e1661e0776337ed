//! The numbers that the solver computes with.

use nalgebra::{
    ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign, Complex, RealField,
};
use num_traits::{One, Zero};

/// The operations that generated code needs of a number: arithmetic without branches.
///
/// Implemented by `f32`, `f64` and complex numbers. Lanes of numbers can implement it too, because nothing here
/// compares.
pub trait Scalar:
    nalgebra::Scalar
    + Copy
    + Send
    + Sync
    + Default
    + Zero
    + One
    + core::ops::Neg<Output = Self>
    + ClosedAddAssign
    + ClosedSubAssign
    + ClosedMulAssign
    + ClosedDivAssign
{
    /// The number nearest to `value`.
    fn constant(value: f64) -> Self;

    /// The nearest whole number, for magnitudes small enough to leave room for a fraction.
    fn nearest_integer(self) -> Self;

    /// `self + a b`. Types with a fused multiply-add round once; `f32` and `f64` round the product too, so that they
    /// give the same bits on every target.
    #[inline(always)]
    fn plus_product(self, a: Self, b: Self) -> Self {
        self + a * b
    }

    /// `self - a b`, rounded as [`plus_product`](Self::plus_product).
    #[inline(always)]
    fn minus_product(self, a: Self, b: Self) -> Self {
        self - a * b
    }
}

/// A single number that can be compared and that defines the accuracy attainable with it.
pub trait Real: Scalar + RealField {
    /// The distance from one to the next larger number.
    const EPSILON: Self;

    /// The smallest positive number with full precision.
    const SMALLEST: Self;

    /// The larger of two magnitudes.
    fn larger_magnitude(self, other: Self) -> Self;

    /// The angle of `(x, y)` from the first axis, from -pi to pi. `f32` and `f64` give the same bits on every target,
    /// whatever features of nalgebra other crates enable.
    fn arc_tangent(y: Self, x: Self) -> Self {
        y.atan2(x)
    }
}

impl Scalar for f32 {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        value as f32
    }

    #[inline(always)]
    fn nearest_integer(self) -> Self {
        // A sum with a number this large has no digits left for a fraction.
        const LARGE: f32 = 1.5 / f32::EPSILON;
        (self + LARGE) - LARGE
    }
}

impl Real for f32 {
    const EPSILON: Self = f32::EPSILON;
    const SMALLEST: Self = f32::MIN_POSITIVE;

    #[inline(always)]
    fn larger_magnitude(self, other: Self) -> Self {
        f32::max(f32::abs(self), f32::abs(other))
    }

    #[inline]
    fn arc_tangent(y: Self, x: Self) -> Self {
        libm::atan2f(y, x)
    }
}

impl Scalar for f64 {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn nearest_integer(self) -> Self {
        // A sum with a number this large has no digits left for a fraction.
        const LARGE: f64 = 1.5 / f64::EPSILON;
        (self + LARGE) - LARGE
    }
}

impl Real for f64 {
    const EPSILON: Self = f64::EPSILON;
    const SMALLEST: Self = f64::MIN_POSITIVE;

    #[inline(always)]
    fn larger_magnitude(self, other: Self) -> Self {
        f64::max(f64::abs(self), f64::abs(other))
    }

    #[inline]
    fn arc_tangent(y: Self, x: Self) -> Self {
        libm::atan2(y, x)
    }
}

/// The equations of a linkage are polynomials, so they have complex roots too, which are connected where the real
/// roots are not.
impl Scalar for Complex<f64> {
    fn constant(value: f64) -> Self {
        Self::from(value)
    }

    fn nearest_integer(self) -> Self {
        Self::new(self.re.nearest_integer(), self.im.nearest_integer())
    }
}
