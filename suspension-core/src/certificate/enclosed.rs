//! Numbers known to within a radius, each operation with a bound of its rounding.

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

use crate::arithmetic::scalar::{Real, Scalar};

/// All numbers within `radius` of `value`: of whatever numbers within two enclosures, sum,
/// difference, product and quotient lie within that of the enclosures.
///
/// Rests on IEEE arithmetic that rounds to nearest, with gradual underflow: of a result `x` rounding
/// takes no more than `EPSILON |x| / 2`, and half the smallest subnormal number where a product or
/// a quotient underflows. The radius has twice that, and is itself the result of a dozen operations
/// at most on positive numbers, for which it is enlarged by `8 EPSILON`; `SMALLEST`, which is
/// `1 / EPSILON` times the smallest subnormal number, covers what underflows in these. A result that
/// is not finite has a radius that is not.
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

    /// All numbers within `radius`, which is not negative, of `value`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn within(value: T, radius: T) -> Self {
        Self { value, radius }
    }

    /// The middle.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn value(self) -> T {
        self.value
    }

    /// How far the numbers lie from the middle, at most.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn radius(self) -> T {
        self.radius
    }

    /// A number not below the magnitude of any within.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn magnitude(self) -> T {
        (self.value.abs() + self.radius) * enlargement()
    }

    /// A number not above any within.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn least(self) -> T {
        let least = self.value - self.radius;
        least - least.abs() * T::EPSILON
    }

    /// The same and all numbers not farther than `by` from it.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn widened(self, by: T) -> Self {
        Self::rounded(self.value, self.radius + by, T::zero())
    }

    /// A result `value` whose operands' radii make `spread`, and which is off by the rounding of
    /// numbers whose magnitudes sum to `magnitude`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rounded(value: T, spread: T, magnitude: T) -> Self {
        let rounding = magnitude * T::EPSILON + T::SMALLEST;
        let radius = (spread + rounding) * enlargement();
        Self { value, radius }
    }
}

/// `1 + 8 EPSILON`: makes up for the rounding of a dozen operations on positive numbers.
#[cfg_attr(not(debug_assertions), inline(always))]
fn enlargement<T: Real>() -> T {
    T::one() + T::EPSILON * T::constant(8.0)
}

/// The radius of a product but for its rounding.
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
    /// Where zero is within the divisor the radius is infinite.
    ///
    /// `a'/b' - a/b = ((a' - a) - a/b (b' - b)) / b'`, with `SMALLEST` for what underflows before
    /// the division by a small `b'`.
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
    /// `value` to all its digits is within.
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

    /// The whole number nearest to the middle, exactly. Where it is asked for
    /// ([`sine_cosine`](crate::arithmetic::trigonometry::sine_cosine)) any whole number near by will do, as
    /// long as it is one.
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
