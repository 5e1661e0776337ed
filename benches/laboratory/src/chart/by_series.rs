//! The motion computed only from its series.

use nalgebra::SVector;
use suspension_core::linkage::Linkage;
use suspension_core::step::series::{InputSeries, Jet, SeriesTracker};
use suspension_core::{Motion, Real, Still, Values};

use super::course::{Given, cast};
use super::formulation::to_f64;
use super::method::{Coordinates, Method, Outputs};

/// One factorisation per step and a Taylor series of order `K` from it, for all outputs.
#[derive(Clone, Copy, Debug)]
pub struct BySeries<R, const K: usize>(pub R);

impl<T, D, L, const N: usize, const K: usize> Method<D, N> for BySeries<&L, K>
where
    T: Real,
    D: Values<f64>,
    L: Linkage<N, Scalar = T>,
{
    type Input = InputSeries<Still, L::Drives, K>;
    type State = Motion<T, N>;

    fn input(&self, from: &Given<D>, _: &Given<D>) -> Self::Input {
        InputSeries::still(Jet {
            value: cast(&from.signal.value),
            terms: std::array::from_fn(|index| {
                from.terms.get(index).map_or_else(L::Drives::default, cast)
            }),
        })
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
        // The chart shows the error, so every step is accepted.
        let tracker = SeriesTracker::within(self.0.size());
        let step = tracker.step(self.0, input, T::constant(dt), &mut next);
        step.ok().map(|_| next)
    }

    fn coordinates(&self, state: &Motion<T, N>) -> Coordinates<N> {
        [state.position, state.velocity, state.acceleration].map(to_f64)
    }
}
