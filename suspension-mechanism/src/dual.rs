//! Numbers with their derivatives in several directions at once.

use std::array::from_fn;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};
use suspension_core::signal::Number;

/// A number with its first derivatives in `D` directions: a formula gives its value and, by the chain rule, these
/// derivatives. If `T` has derivatives itself, the mixed second derivatives result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<T, const D: usize> {
    /// The number.
    pub value: T,
    /// Its derivatives.
    pub rates: [T; D],
}

impl<T: Number, const D: usize> Dual<T, D> {
    /// A number that does not change.
    #[inline]
    pub fn still(value: T) -> Self {
        Self {
            value,
            rates: [T::zero(); D],
        }
    }

    #[inline]
    fn new(value: T, rate: impl Fn(usize) -> T) -> Self {
        Self {
            value,
            rates: from_fn(rate),
        }
    }

    /// A function of two numbers by its value and its derivatives with respect to each.
    #[inline]
    fn from_partials([a, b]: [Self; 2], value: T, [by_a, by_b]: [T; 2]) -> Self {
        Self::new(value, |direction| {
            a.rates[direction] * by_a + b.rates[direction] * by_b
        })
    }
}

impl<T: Number, const D: usize> Number for Dual<T, D> {
    #[inline]
    fn square_root(self) -> Self {
        let value = self.value.square_root();
        let scale = T::one() / (value + value);
        Self::new(value, |direction| self.rates[direction] * scale)
    }

    #[inline]
    fn arc_tangent(y: Self, x: Self) -> Self {
        let square = x.value * x.value + y.value * y.value;
        let value = T::arc_tangent(y.value, x.value);
        Self::from_partials([y, x], value, [x.value / square, -y.value / square])
    }

    #[inline]
    fn is_below_zero(&self) -> bool {
        self.value.is_below_zero()
    }
}

impl<T: Number, const D: usize> Neg for Dual<T, D> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.value, |direction| -self.rates[direction])
    }
}

impl<T: Number, const D: usize> Add for Dual<T, D> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, |direction| {
            self.rates[direction] + other.rates[direction]
        })
    }
}

impl<T: Number, const D: usize> Sub for Dual<T, D> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, |direction| {
            self.rates[direction] - other.rates[direction]
        })
    }
}

impl<T: Number, const D: usize> Mul for Dual<T, D> {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::from_partials(
            [self, other],
            self.value * other.value,
            [other.value, self.value],
        )
    }
}

impl<T: Number, const D: usize> Div for Dual<T, D> {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let inverse = T::one() / other.value;
        Self::from_partials([self, other], value, [inverse, -value * inverse])
    }
}

impl<T: Number, const D: usize> Zero for Dual<T, D> {
    #[inline]
    fn zero() -> Self {
        Self::still(T::zero())
    }

    #[inline]
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl<T: Number, const D: usize> One for Dual<T, D> {
    #[inline]
    fn one() -> Self {
        Self::still(T::one())
    }
}

macro_rules! assign {
    ($($trait:ident $method:ident $operator:tt;)*) => {
        $(
            impl<T: Number, const D: usize> $trait for Dual<T, D> {
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
