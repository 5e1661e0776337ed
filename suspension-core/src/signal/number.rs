//! Signals as numbers: a formula of changing quantities gives its value and, by the chain rule, both
//! derivatives.

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use nalgebra::{ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign, Vector3};
use num_traits::{One, Zero};

use super::Signal;
use crate::arithmetic::scalar::Real;

/// The operations that the formulas of [`wheel`](crate::wheel) need of a number. Implemented by real numbers, and by
/// a [`Signal`] of one, with which the formula gives derivatives too.
pub trait Number:
    nalgebra::Scalar
    + Copy
    + Zero
    + One
    + Neg<Output = Self>
    + ClosedAddAssign
    + ClosedSubAssign
    + ClosedMulAssign
    + ClosedDivAssign
{
    /// The square root; at zero its derivatives are not finite.
    fn square_root(self) -> Self;

    /// The angle of the direction `(x, y)` from the x axis: `atan2`.
    fn arc_tangent(y: Self, x: Self) -> Self;

    /// Whether it is less than zero.
    fn is_below_zero(&self) -> bool;

    /// Its magnitude; at zero it has the derivatives of a positive number.
    #[inline]
    fn magnitude(self) -> Self {
        if self.is_below_zero() { -self } else { self }
    }
}

impl<T: Real> Number for T {
    #[inline]
    fn square_root(self) -> Self {
        self.sqrt()
    }

    #[inline]
    fn arc_tangent(y: Self, x: Self) -> Self {
        T::arc_tangent(y, x)
    }

    #[inline]
    fn is_below_zero(&self) -> bool {
        *self < T::zero()
    }
}

impl<T: Real> Signal<Vector3<T>> {
    /// The vector of its components as numbers.
    #[inline]
    pub fn components(&self) -> Vector3<Signal<T>> {
        let component =
            |axis: usize| self.map(|vector| vector.get(axis).copied().unwrap_or_default());
        Vector3::new(component(0), component(1), component(2))
    }
}

impl<T: Real> Number for Signal<T> {
    #[inline]
    fn square_root(self) -> Self {
        let two = T::one() + T::one();
        let value = self.value.sqrt();
        let rate = self.rate / (two * value);
        Self {
            value,
            rate,
            second_rate: (self.second_rate / two - rate * rate) / value,
        }
    }

    #[inline]
    fn arc_tangent(y: Self, x: Self) -> Self {
        let two = T::one() + T::one();
        let square = x.value * x.value + y.value * y.value;
        let rate = (x.value * y.rate - y.value * x.rate) / square;
        let swept = x.value * y.second_rate - y.value * x.second_rate;
        let outward = x.value * x.rate + y.value * y.rate;
        Self {
            value: T::arc_tangent(y.value, x.value),
            rate,
            second_rate: (swept - two * rate * outward) / square,
        }
    }

    #[inline]
    fn is_below_zero(&self) -> bool {
        self.value < T::zero()
    }
}

impl<T: Real> Add for Signal<T> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            rate: self.rate + other.rate,
            second_rate: self.second_rate + other.second_rate,
        }
    }
}

impl<T: Real> Neg for Signal<T> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        self.map(|number| -*number)
    }
}

impl<T: Real> Sub for Signal<T> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<T: Real> Mul for Signal<T> {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let two = T::one() + T::one();
        Self {
            value: self.value * other.value,
            rate: self.rate * other.value + self.value * other.rate,
            second_rate: self.second_rate * other.value
                + two * self.rate * other.rate
                + self.value * other.second_rate,
        }
    }
}

impl<T: Real> Div for Signal<T> {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let two = T::one() + T::one();
        let value = self.value / other.value;
        let rate = (self.rate - value * other.rate) / other.value;
        let second = self.second_rate - two * rate * other.rate - value * other.second_rate;
        Self {
            value,
            rate,
            second_rate: second / other.value,
        }
    }
}

impl<T: Real> Zero for Signal<T> {
    #[inline]
    fn zero() -> Self {
        Self::still(T::zero())
    }

    #[inline]
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl<T: Real> One for Signal<T> {
    #[inline]
    fn one() -> Self {
        Self::still(T::one())
    }
}

macro_rules! assign {
    ($($trait:ident $method:ident $operator:tt;)*) => {
        $(
            impl<T: Real> $trait for Signal<T> {
                #[inline]
                fn $method(&mut self, other: Self) {
                    *self = *self $operator other;
                }
            }
        )*
    };
}

assign! {
    AddAssign add_assign +;
    SubAssign sub_assign -;
    MulAssign mul_assign *;
    DivAssign div_assign /;
}
