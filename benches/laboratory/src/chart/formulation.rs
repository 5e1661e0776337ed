//! Formulations of the mechanism's equations, each in its own coordinates.

pub mod absolute;
pub mod five_links;
pub mod points;
pub mod relative;

use nalgebra::{SMatrix, SVector};
use suspension_core::{Real, Signal, Values};

/// Position, velocity and acceleration of `M` coordinates.
pub type State<T, const M: usize> = [SVector<T, M>; 3];

/// `F(x, u) = 0` in `M` coordinates `x` with inputs `u`; lengths in metres, time in seconds.
///
/// Velocities and accelerations solve `J xdot = rate` and `J xddot = second_rate`.
pub trait Formulation<T: Real, D, const M: usize, const N: usize> {
    /// The prescribed quantities at an instant.
    type Input: Copy;

    /// The inputs of an instant.
    fn input(&self, drives: &Signal<D>) -> Self::Input;

    /// The longest length.
    fn size(&self) -> T;

    /// `F(x, u)`, in units of length.
    fn residual(&self, x: &SVector<T, M>, input: &Self::Input) -> SVector<T, M>;

    /// `J = dF/dx`.
    fn jacobian(&self, x: &SVector<T, M>, input: &Self::Input) -> SMatrix<T, M, M>;

    /// `-dF/du udot`.
    fn rate(&self, x: &SVector<T, M>, input: &Self::Input) -> SVector<T, M>;

    /// `-dF/du uddot`, less the terms of `F` that are quadratic in the velocities.
    fn second_rate(
        &self,
        x: &SVector<T, M>,
        velocity: &SVector<T, M>,
        input: &Self::Input,
    ) -> SVector<T, M>;

    /// Returns the coordinates for the given coordinates of the free points.
    fn near_points(&self, position: &SVector<f64, N>) -> SVector<T, M>;

    /// The coordinates of the free points.
    fn points(&self, state: &State<T, M>) -> [SVector<f64, N>; 3];
}

/// Converts numbers to `f64`.
pub fn to_f64<T: Real, const N: usize>(vector: SVector<T, N>) -> SVector<f64, N> {
    vector.map(|x| x.to_subset_unchecked())
}

/// The first drive, in another number type.
pub fn first_drive<T: Real, D: Values<f64>>(drives: &Signal<D>) -> Signal<T> {
    let first = |drives: &D| T::constant(drives.values().next().unwrap_or_default());
    Signal {
        value: first(&drives.value),
        rate: first(&drives.rate),
        second_rate: first(&drives.second_rate),
    }
}
