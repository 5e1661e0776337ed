//! Point coordinates: the equations of the listing.

use nalgebra::{SMatrix, SVector};
use suspension_core::solve::motion::Prescribed;
use suspension_core::{Inputs, Linkage, Real, Signal, Still, Values};

use super::{Formulation, State};
use crate::chart::course::cast_drives;

/// A linkage with the equations of its listing.
#[derive(Clone, Copy, Debug)]
pub struct Points<R>(pub R);

impl<T, L, D, const N: usize> Formulation<T, D, N, N> for Points<&L>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
    L::Fixed: Copy,
    D: Values<f64>,
{
    type Input = Prescribed<L::Fixed, L::Drives>;

    fn input(&self, drives: &Signal<D>) -> Self::Input {
        Prescribed::new(self.0, &Inputs::<Still, _>::still(cast_drives(drives)))
    }

    fn size(&self) -> T {
        self.0.size()
    }

    fn residual(&self, x: &SVector<T, N>, input: &Self::Input) -> SVector<T, N> {
        let Prescribed { fixed, drives } = input;
        self.0.residual(x, &fixed.value, &drives.value)
    }

    fn jacobian(&self, x: &SVector<T, N>, input: &Self::Input) -> SMatrix<T, N, N> {
        self.0.jacobian(x, &input.fixed.value)
    }

    fn rate(&self, x: &SVector<T, N>, input: &Self::Input) -> SVector<T, N> {
        let Prescribed { fixed, drives } = input;
        self.0
            .drive_rate(x, &fixed.value, &fixed.rate, &drives.rate)
    }

    fn second_rate(
        &self,
        x: &SVector<T, N>,
        velocity: &SVector<T, N>,
        input: &Self::Input,
    ) -> SVector<T, N> {
        let Prescribed { fixed, drives } = input;
        let driven = self
            .0
            .drive_rate(x, &fixed.value, &fixed.second_rate, &drives.second_rate);
        let rate = &fixed.rate;
        driven - self.0.curvature(velocity, rate, velocity, rate)
    }

    fn near_points(&self, position: &SVector<f64, N>) -> SVector<T, N> {
        position.map(T::constant)
    }

    fn points(&self, state: &State<T, N>) -> [SVector<f64, N>; 3] {
        state.map(super::to_f64)
    }
}
