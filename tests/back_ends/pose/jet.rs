//! Numbers of about 32 digits with their first and second derivative over time, and vectors of them.

use std::ops::{Add, Mul, Sub};

use nalgebra::Vector3;
use suspension_core::Signal;
use suspension_double_double::DoubleDouble;

/// A value, its rate and its second rate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jet(pub(crate) [DoubleDouble; 3]);

impl Jet {
    /// Makes a constant.
    pub(crate) fn constant(value: DoubleDouble) -> Self {
        Self([value, 0.0.into(), 0.0.into()])
    }

    /// An input, taken as exact.
    pub(crate) fn input(signal: &Signal<f64>) -> Self {
        Self([signal.value, signal.rate, signal.second_rate].map(DoubleDouble::from))
    }

    /// Sine and cosine.
    pub(crate) fn sine_cosine(self) -> [Self; 2] {
        let [value, rate, second_rate] = self.0;
        let (sine, cosine) = value.sine_cosine();
        let square = rate * rate;
        [
            Self([sine, cosine * rate, cosine * second_rate - sine * square]),
            Self([cosine, -sine * rate, -sine * second_rate - cosine * square]),
        ]
    }

    /// The square root of a constant.
    pub(crate) fn root(self) -> Self {
        let [value, ..] = self.0;
        let root = DoubleDouble::from(value.nearest().sqrt());
        Self::constant((root + value / root) * DoubleDouble::from(0.5))
    }

    /// The reciprocal of a constant.
    pub(crate) fn reciprocal(self) -> Self {
        Self::constant(DoubleDouble::from(1.0) / self.0[0])
    }
}

impl From<f64> for Jet {
    fn from(value: f64) -> Self {
        Self::constant(value.into())
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self([0, 1, 2].map(|order| self.0[order] + other.0[order]))
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self([0, 1, 2].map(|order| self.0[order] - other.0[order]))
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let ([a, da, dda], [b, db, ddb]) = (self.0, other.0);
        let mixed = da * db;
        Self([a * b, da * b + a * db, dda * b + mixed + mixed + a * ddb])
    }
}

/// A vector of such numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vector(pub(crate) [Jet; 3]);

impl Vector {
    pub(crate) fn dot(self, other: Self) -> Jet {
        let ([a, b, c], [d, e, f]) = (self.0, other.0);
        a * d + b * e + c * f
    }

    pub(crate) fn cross(self, other: Self) -> Self {
        let ([a, b, c], [d, e, f]) = (self.0, other.0);
        Self([b * f - c * e, c * d - a * f, a * e - b * d])
    }

    /// The direction of a constant vector.
    pub(crate) fn unit(self) -> Self {
        self * self.dot(self).root().reciprocal()
    }
}

impl From<Vector3<f64>> for Vector {
    fn from(vector: Vector3<f64>) -> Self {
        Self([vector.x, vector.y, vector.z].map(Jet::from))
    }
}

impl Add for Vector {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self([0, 1, 2].map(|axis| self.0[axis] + other.0[axis]))
    }
}

impl Sub for Vector {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self([0, 1, 2].map(|axis| self.0[axis] - other.0[axis]))
    }
}

impl Mul<Jet> for Vector {
    type Output = Self;
    fn mul(self, factor: Jet) -> Self {
        Self(self.0.map(|entry| entry * factor))
    }
}
