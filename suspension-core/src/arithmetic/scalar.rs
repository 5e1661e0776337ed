//! The numbers that the solver computes with.

use nalgebra::{
    ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign, Complex, RealField,
};
use num_traits::{One, Zero};

/// What generated code needs of a number: arithmetic without branches.
///
/// Met by `f32`, `f64` and complex numbers; lanes of them can meet it too, because nothing here
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

    /// The nearest whole number, for magnitudes that leave room for a fraction.
    fn nearest_integer(self) -> Self;

    /// `self + a b`. Numbers that fuse round once; `f32` and `f64` round the product too, so that
    /// they give the same bits on every target.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn plus_product(self, a: Self, b: Self) -> Self {
        self + a * b
    }

    /// `self - a b`, rounded as [`plus_product`](Self::plus_product).
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn minus_product(self, a: Self, b: Self) -> Self {
        self - a * b
    }
}

/// A single number that can be compared, and that owns the accuracy which can be asked of it.
pub trait Real: Scalar + RealField {
    /// Distance from one to the next larger number.
    const EPSILON: Self;

    /// The smallest positive number that has all its digits.
    const SMALLEST: Self;

    /// The larger of two magnitudes.
    fn larger_magnitude(self, other: Self) -> Self;

    /// The angle of `(x, y)` from the first axis, from -pi to pi: of `f32` and `f64` the same bits on every target, and whatever
    /// features of nalgebra other crates ask for.
    fn arc_tangent(y: Self, x: Self) -> Self {
        y.atan2(x)
    }
}

impl Scalar for f32 {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn constant(value: f64) -> Self {
        value as f32
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn nearest_integer(self) -> Self {
        // Beside a number this large there is no room for a fraction.
        const LARGE: f32 = 1.5 / f32::EPSILON;
        (self + LARGE) - LARGE
    }
}

impl Real for f32 {
    const EPSILON: Self = f32::EPSILON;
    const SMALLEST: Self = f32::MIN_POSITIVE;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn larger_magnitude(self, other: Self) -> Self {
        f32::max(f32::abs(self), f32::abs(other))
    }

    #[inline]
    fn arc_tangent(y: Self, x: Self) -> Self {
        libm::atan2f(y, x)
    }
}

impl Scalar for f64 {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn constant(value: f64) -> Self {
        value
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn nearest_integer(self) -> Self {
        // Beside a number this large there is no room for a fraction.
        const LARGE: f64 = 1.5 / f64::EPSILON;
        (self + LARGE) - LARGE
    }
}

impl Real for f64 {
    const EPSILON: Self = f64::EPSILON;
    const SMALLEST: Self = f64::MIN_POSITIVE;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn larger_magnitude(self, other: Self) -> Self {
        f64::max(f64::abs(self), f64::abs(other))
    }

    #[inline]
    fn arc_tangent(y: Self, x: Self) -> Self {
        libm::atan2(y, x)
    }
}

/// The equations of a linkage are polynomials: they have complex roots too, and those hang together
/// where real ones do not.
impl Scalar for Complex<f64> {
    fn constant(value: f64) -> Self {
        Self::from(value)
    }

    fn nearest_integer(self) -> Self {
        Self::new(self.re.nearest_integer(), self.im.nearest_integer())
    }
}
