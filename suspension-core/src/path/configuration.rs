//! Unknowns and the coordinate of the drive that is set free: points of a curve, and its tangents.

use core::ops::{Add, Mul, Sub};

use nalgebra::SVector;

use crate::arithmetic::entrywise::{difference, multiple, sum};
use crate::arithmetic::scalar::Real;

/// The `N` unknowns and, as entry `N`, the coordinate of the drive that is set free; or the rates of these.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Configuration<T, const N: usize> {
    /// `q`, in units of length.
    pub unknowns: SVector<T, N>,
    /// The drive's coordinate, in units of length: `h = L cos(theta)` for an angle, `h = L sin(theta / 4)` for an
    /// angle about an axis.
    pub drive: T,
}

impl<T: Real, const N: usize> Configuration<T, N> {
    pub(crate) fn zero() -> Self {
        Self {
            unknowns: SVector::from([T::zero(); N]),
            drive: T::zero(),
        }
    }

    /// Entry `index`; from `N` on, the entry of the drive.
    pub(crate) fn entry(&self, index: usize) -> T {
        let [unknowns] = &self.unknowns.data.0;
        unknowns.get(index).copied().unwrap_or(self.drive)
    }

    /// The same configuration with one entry replaced.
    pub(crate) fn with_entry(mut self, index: usize, value: T) -> Self {
        let [unknowns] = &mut self.unknowns.data.0;
        *unknowns.get_mut(index).unwrap_or(&mut self.drive) = value;
        self
    }

    /// The index of the entry with the largest magnitude.
    pub(crate) fn largest_entry(&self) -> usize {
        let mut best = (N, self.drive.abs());
        for (index, entry) in self.unknowns.iter().enumerate() {
            if entry.abs() > best.1 {
                best = (index, entry.abs());
            }
        }
        best.0
    }

    pub(crate) fn dot(&self, other: &Self) -> T {
        let pairs = self.unknowns.iter().zip(other.unknowns.iter());
        pairs.fold(self.drive * other.drive, |sum, (a, b)| sum + *a * *b)
    }

    /// The Euclidean norm.
    pub fn norm(&self) -> T {
        self.dot(self).sqrt()
    }
}

impl<T: Real, const N: usize> Add for Configuration<T, N> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            unknowns: sum(&self.unknowns, &other.unknowns),
            drive: self.drive + other.drive,
        }
    }
}

impl<T: Real, const N: usize> Sub for Configuration<T, N> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self {
            unknowns: difference(&self.unknowns, &other.unknowns),
            drive: self.drive - other.drive,
        }
    }
}

impl<T: Real, const N: usize> Mul<T> for Configuration<T, N> {
    type Output = Self;

    fn mul(self, factor: T) -> Self {
        Self {
            unknowns: multiple(&self.unknowns, factor),
            drive: self.drive * factor,
        }
    }
}
