//! The prediction of the next position from the last motion, and the corrections of velocity and acceleration by its error.

use nalgebra::SVector;

use crate::arithmetic::entrywise::{difference, minus_multiple, multiple, plus_multiple};
use crate::arithmetic::scalar::Scalar;
use crate::solve::motion::Motion;

/// A predicted position with the rates of the polynomial that led to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Prediction<T, const N: usize, const ORDER: usize> {
    pub(super) position: SVector<T, N>,
    velocity: SVector<T, N>,
    acceleration: SVector<T, N>,
    /// `1 / dt`, or zero for a step of zero length.
    per_step: T,
}

impl<T: Scalar, const N: usize, const ORDER: usize> Prediction<T, N, ORDER> {
    /// The Taylor polynomial of the last motion, evaluated `dt` later.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn new(from: &Motion<T, N>, dt: T) -> Self {
        let zero = SVector::from([T::zero(); N]);
        let (q, v, a) = (&from.position, &from.velocity, &from.acceleration);
        let (position, velocity, acceleration) = match ORDER {
            0 => (*q, zero, zero),
            1 => (plus_multiple(q, v, dt), *v, zero),
            _ => {
                let mean = plus_multiple(v, a, dt * T::constant(0.5));
                (plus_multiple(q, &mean, dt), plus_multiple(v, a, dt), *a)
            }
        };
        // Far less than the square of any step that can be told from zero.
        let tiny = T::constant(1e-30);
        Self {
            position,
            velocity,
            acceleration,
            per_step: dt / tiny.plus_product(dt, dt),
        }
    }

    /// The velocity at the end, if the error `e` of the prediction grows as `dt^(p + 1)`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn velocity(&self, error: &SVector<T, N>) -> SVector<T, N> {
        let power = T::constant((ORDER + 1) as f64);
        minus_multiple(&self.velocity, error, self.per_step * power)
    }

    /// The acceleration at the end, on the same assumption.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn acceleration(&self, error: &SVector<T, N>) -> SVector<T, N> {
        let powers = T::constant((ORDER * (ORDER + 1)) as f64);
        let rate = self.per_step * self.per_step * powers;
        minus_multiple(&self.acceleration, error, rate)
    }

    /// The velocity at the end from positions alone. After a prediction with the (mean) acceleration it is `3/2 d -
    /// (v1 + v2) / 4`, with `d` the mean velocity of the step and `v1`, `v2` the velocities before it: this is of
    /// second order, and errors halve from step to step. After other predictions it is `d`. With the full power of
    /// [`velocity`](Self::velocity) instead, errors would grow.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn velocity_from_positions(&self, error: &SVector<T, N>) -> SVector<T, N> {
        let power = T::constant(if ORDER < 2 { 1.0 } else { 1.5 });
        minus_multiple(&self.velocity, error, self.per_step * power)
    }

    /// The mean acceleration of the step.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn mean_acceleration(
        &self,
        from: &Motion<T, N>,
        velocity: &SVector<T, N>,
    ) -> SVector<T, N> {
        multiple(&difference(velocity, &from.velocity), self.per_step)
    }
}
