//! Numbers known to within a radius, each operation with a bound of its rounding.

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

use crate::arithmetic::scalar::{Real, Scalar};

/// All numbers within `radius` of `value`. For any numbers within two enclosures, their sum, difference, product and
/// quotient lie within the sum, difference, product and quotient of the enclosures.
///
/// Relies on IEEE arithmetic that rounds to nearest, with gradual underflow: rounding changes a result `x` by at most
/// `EPSILON |x| / 2`, and by half the smallest subnormal number where a product or a quotient underflows. The radius
/// includes twice that. It is itself the result of at most a dozen operations on positive numbers, and is enlarged by
/// `8 EPSILON` for them; `SMALLEST`, which is `1 / EPSILON` times the smallest subnormal number, covers underflow in
/// these operations. If a result is not finite, neither is its radius.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Enclosed<T> {
    value: T,
    radius: T,
}

impl<T: Real> Enclosed<T> {
    /// This number alone.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn exact(value: T) -> Self {
        let radius = T::zero();
        Self { value, radius }
    }

    /// All numbers within `radius`, which must not be negative, of `value`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn within(value: T, radius: T) -> Self {
        Self { value, radius }
    }

    /// The midpoint.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn value(self) -> T {
        self.value
    }

    /// The largest distance of the numbers from the midpoint.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn radius(self) -> T {
        self.radius
    }

    /// An upper bound of the magnitudes of the numbers.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn magnitude(self) -> T {
        (self.value.abs() + self.radius) * enlargement()
    }

    /// A lower bound of the numbers.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn least(self) -> T {
        let least = self.value - self.radius;
        least - least.abs() * T::EPSILON
    }

    /// This enclosure, extended by `by` in both directions.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn widened(self, by: T) -> Self {
        Self::rounded(self.value, self.radius + by, T::zero())
    }

    /// A result `value`: the radii of its operands contribute `spread`, and its rounding error is that of numbers
    /// whose magnitudes sum to `magnitude`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rounded(value: T, spread: T, magnitude: T) -> Self {
        let rounding = magnitude * T::EPSILON + T::SMALLEST;
        let radius = (spread + rounding) * enlargement();
        Self { value, radius }
    }
}

/// `1 + 8 EPSILON`: compensates for the rounding of a dozen operations on positive numbers.
#[cfg_attr(not(debug_assertions), inline(always))]
fn enlargement<T: Real>() -> T {
    T::one() + T::EPSILON * T::constant(8.0)
}

/// The radius of a product without its rounding error.
#[cfg_attr(not(debug_assertions), inline(always))]
fn spread_of_product<T: Real>(a: Enclosed<T>, b: Enclosed<T>) -> T {
    a.value.abs() * b.radius + a.radius * (b.value.abs() + b.radius)
}

impl<T: Real> Add for Enclosed<T> {
    type Output = Self;
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        Self::rounded(value, self.radius + other.radius, value.abs())
    }
}

impl<T: Real> Sub for Enclosed<T> {
    type Output = Self;
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<T: Real> Mul for Enclosed<T> {
    type Output = Self;
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        Self::rounded(value, spread_of_product(self, other), value.abs())
    }
}

impl<T: Real> Div for Enclosed<T> {
    type Output = Self;
    /// The radius is infinite if the divisor encloses zero.
    ///
    /// `a'/b' - a/b = ((a' - a) - a/b (b' - b)) / b'`, with `SMALLEST` for underflow before the division by a small
    /// `b'`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let nearest_zero = other.value.abs() - other.radius;
        let spread = if nearest_zero > T::zero() && other.value.is_finite() {
            let of_divisor = (value.abs() + T::SMALLEST) * other.radius;
            (self.radius + of_divisor + T::SMALLEST) / nearest_zero
        } else {
            T::one() / T::zero()
        };
        Self::rounded(value, spread, value.abs())
    }
}

impl<T: Real> Neg for Enclosed<T> {
    type Output = Self;
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn neg(self) -> Self {
        Self::within(-self.value, self.radius)
    }
}

macro_rules! assignments {
    ($($operation:ident $method:ident $symbol:tt;)*) => {$(
        impl<T: Real> $operation for Enclosed<T> {
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn $method(&mut self, other: Self) {
                *self = *self $symbol other;
            }
        }
    )*};
}
assignments! {
    AddAssign add_assign +;
    SubAssign sub_assign -;
    MulAssign mul_assign *;
    DivAssign div_assign /;
}

impl<T: Real> Zero for Enclosed<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn zero() -> Self {
        Self::exact(T::zero())
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl<T: Real> One for Enclosed<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn one() -> Self {
        Self::exact(T::one())
    }
}

impl<T: Real> Scalar for Enclosed<T> {
    /// Encloses the exact `value`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn constant(value: f64) -> Self {
        let nearest = T::constant(value);
        let stored: f64 = nearest.to_subset_unchecked();
        if stored == value {
            Self::exact(nearest)
        } else {
            Self::rounded(nearest, T::zero(), nearest.abs())
        }
    }

    /// The whole number nearest to the midpoint, exactly.
    /// [`sine_cosine`](crate::arithmetic::trigonometry::sine_cosine), which uses it, needs only some whole number
    /// near by.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn nearest_integer(self) -> Self {
        Self::exact(self.value.nearest_integer())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn plus_product(self, a: Self, b: Self) -> Self {
        let product = a.value * b.value;
        let value = self.value + product;
        let spread = self.radius + spread_of_product(a, b);
        Self::rounded(value, spread, value.abs() + product.abs())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn minus_product(self, a: Self, b: Self) -> Self {
        self.plus_product(-a, b)
    }
}
