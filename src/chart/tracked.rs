//! The real-time loop of the core.

use nalgebra::SVector;
use suspension_core::bounded::Bounded;
use suspension_core::{Inputs, Linkage, Motion, Named, Real, Still, Tracker};

use super::course::{Given, cast_drives};
use super::formulation::to_f64;
use super::method::{Coordinates, Method, Outputs};

/// The generated elimination, iterated to tolerance: all of the motion, whatever is asked.
#[derive(Clone, Copy, Debug)]
pub struct Generated<R>(pub R);

impl<T, D, L, const N: usize> Method<D, N> for Generated<&L>
where
    T: Real,
    D: Named<f64>,
    L: Linkage<N, Scalar = T>,
{
    type Input = Inputs<Still, L::Drives>;
    type State = Motion<T, N>;

    fn input(&self, _: &Given<D>, to: &Given<D>) -> Self::Input {
        Inputs::still(cast_drives(&to.signal))
    }

    fn rest(&self, position: &SVector<f64, N>) -> Motion<T, N> {
        Motion::at_rest(position.map(T::constant))
    }

    fn step(
        &self,
        _: Outputs,
        input: &Self::Input,
        dt: f64,
        from: &Motion<T, N>,
    ) -> Option<Motion<T, N>> {
        let mut next = *from;
        let step = Tracker::default().step(self.0, input, T::constant(dt), &mut next);
        step.ok().map(|_| next)
    }

    fn coordinates(&self, state: &Motion<T, N>) -> Coordinates<N> {
        [state.position, state.velocity, state.acceleration].map(to_f64)
    }
}

/// One factorisation and `SWEEPS` solutions for each of position, velocity and acceleration.
#[derive(Clone, Copy, Debug)]
pub struct InSweeps<R, const SWEEPS: usize>(pub R);

impl<T, D, L, const N: usize, const SWEEPS: usize> Method<D, N> for InSweeps<&L, SWEEPS>
where
    T: Real,
    D: Named<f64>,
    L: Linkage<N, Scalar = T>,
{
    type Input = Inputs<Still, L::Drives>;
    type State = Motion<T, N>;

    fn input(&self, _: &Given<D>, to: &Given<D>) -> Self::Input {
        Inputs::still(cast_drives(&to.signal))
    }

    fn rest(&self, position: &SVector<f64, N>) -> Motion<T, N> {
        Motion::at_rest(position.map(T::constant))
    }

    fn step(
        &self,
        outputs: Outputs,
        input: &Self::Input,
        dt: f64,
        from: &Motion<T, N>,
    ) -> Option<Motion<T, N>> {
        let bounded = Bounded::<T, SWEEPS> {
            // The chart shows the error, whatever it is.
            tolerance: T::one() / T::EPSILON,
            ..Bounded::default()
        };
        let mut next = *from;
        let step = bounded.step_to(outputs, self.0, input, T::constant(dt), &mut next);
        step.ok().map(|_| next)
    }

    fn coordinates(&self, state: &Motion<T, N>) -> Coordinates<N> {
        [state.position, state.velocity, state.acceleration].map(to_f64)
    }
}
