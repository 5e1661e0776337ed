//! The real-time loop of the core.

use nalgebra::SVector;
use suspension_core::{Inputs, Linkage, Motion, Named, Newton, Real, Still, Tangent, Tracker};

use super::course::{Given, cast_drives};
use super::formulation::to_f64;
use super::method::{Coordinates, Method, Outputs};

/// The generated elimination, iterated to tolerance.
#[derive(Debug)]
pub struct Generated<'a, L>(pub &'a L);

impl<L> Clone for Generated<'_, L> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<L> Copy for Generated<'_, L> {}

impl<T, D, L, const N: usize> Method<D, N> for Generated<'_, L>
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
        let dt = T::constant(dt);
        let mut next = *from;
        if outputs == Outputs::Acceleration {
            let step = Tracker::default().step(self.0, input, dt, &mut next);
            return step.ok().map(|_| next);
        }
        next.position = from.predict(dt);
        let newton = Newton::near_by();
        newton.solve(self.0, input, &mut next.position).ok()?;
        if outputs == Outputs::Velocity {
            next.velocity = Tangent::new(self.0, input, &next.position).ok()?.velocity();
        }
        Some(next)
    }

    fn coordinates(&self, state: &Motion<T, N>) -> Coordinates<N> {
        [state.position, state.velocity, state.acceleration].map(to_f64)
    }
}
