//! The real-time loops of the core.

use nalgebra::SVector;
use suspension_core::solve::tolerance::Tolerance;
use suspension_core::step::bounded::Bounded;
use suspension_core::{Inputs, Linkage, Motion, Real, Still, Tracker, Values};

use super::course::{Given, cast_drives};
use super::formulation::to_f64;
use super::method::{Coordinates, Method, Outputs};

/// A linkage, stepped by one of the core's loops.
#[derive(Clone, Copy, Debug)]
pub struct Tracked<R, S> {
    /// The linkage.
    pub linkage: R,
    /// The loop.
    pub stepper: S,
}

/// A loop of the core.
pub trait Stepper: Copy {
    /// Returns the next motion; `None` if there is none.
    fn step<T: Real, L: Linkage<N, Scalar = T>, const N: usize>(
        &self,
        outputs: Outputs,
        linkage: &L,
        inputs: &Inputs<Still, L::Drives>,
        dt: T,
        from: &Motion<T, N>,
    ) -> Option<Motion<T, N>>;

    /// See [`Method::on_the_way`].
    fn on_the_way(&self, outputs: Outputs) -> Outputs;
}

/// Steps to tolerance with all outputs.
#[derive(Clone, Copy, Debug)]
pub struct ToTolerance;

impl Stepper for ToTolerance {
    fn step<T: Real, L: Linkage<N, Scalar = T>, const N: usize>(
        &self,
        _: Outputs,
        linkage: &L,
        inputs: &Inputs<Still, L::Drives>,
        dt: T,
        from: &Motion<T, N>,
    ) -> Option<Motion<T, N>> {
        let mut next = *from;
        let step = Tracker::default().step(linkage, inputs, dt, &mut next);
        step.ok().map(|_| next)
    }

    fn on_the_way(&self, _: Outputs) -> Outputs {
        Outputs::Acceleration
    }
}

/// One factorisation and `CORRECTIONS` solutions for each of position, velocity and acceleration.
#[derive(Clone, Copy, Debug)]
pub struct InCorrections<const CORRECTIONS: usize>;

impl<const CORRECTIONS: usize> Stepper for InCorrections<CORRECTIONS> {
    fn step<T: Real, L: Linkage<N, Scalar = T>, const N: usize>(
        &self,
        outputs: Outputs,
        linkage: &L,
        inputs: &Inputs<Still, L::Drives>,
        dt: T,
        from: &Motion<T, N>,
    ) -> Option<Motion<T, N>> {
        let bounded = Bounded::<T, CORRECTIONS> {
            // The chart shows the error, whatever it is.
            tolerance: Tolerance::Roundings(T::one() / T::EPSILON),
            ..Bounded::new()
        };
        let mut next = *from;
        let step = bounded.step_to(outputs, linkage, inputs, dt, &mut next);
        step.ok().map(|_| next)
    }

    fn on_the_way(&self, outputs: Outputs) -> Outputs {
        outputs
    }
}

impl<T, D, L, S, const N: usize> Method<D, N> for Tracked<&L, S>
where
    T: Real,
    D: Values<f64>,
    L: Linkage<N, Scalar = T>,
    S: Stepper,
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
        let dt = T::constant(dt);
        self.stepper.step(outputs, self.linkage, input, dt, from)
    }

    fn on_the_way(&self, outputs: Outputs) -> Outputs {
        self.stepper.on_the_way(outputs)
    }

    fn coordinates(&self, state: &Motion<T, N>) -> Coordinates<N> {
        [state.position, state.velocity, state.acceleration].map(to_f64)
    }
}
