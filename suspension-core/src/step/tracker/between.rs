//! A step too long for one prediction: inputs between its ends, and sub-steps over them.

use nalgebra::Vector3;

use super::Tracker;
use super::guard::Change;
use crate::arithmetic::scalar::{Real, Scalar};
use crate::linkage::{Linkage, Values};
use crate::signal::{ChassisMotion, Inputs, Signal, Still};
use crate::solve::motion::{Motion, Prescribed};
use crate::solve::report::Report;
use crate::step::substeps::Stopped;

/// The motion of the chassis points `F` between two instants.
pub trait Between<T, F>: ChassisMotion<F> {
    /// Their motion at a place between the motions `self` and `to`.
    fn between(&self, to: &Self, cubic: &Cubic<T>) -> Self;
}

impl<T, F: Copy + Default> Between<T, F> for Still {
    fn between(&self, _to: &Self, _cubic: &Cubic<T>) -> Self {
        Self
    }
}

impl<T: Scalar, F: Values<Vector3<T>>> Between<T, F> for Signal<F> {
    fn between(&self, to: &Self, cubic: &Cubic<T>) -> Self {
        cubic.between(self, to)
    }
}

/// A place on the cubic (Hermite) that has the values and rates of two instants. It is stored as the weights with which
/// those values and rates make up the value, the rate and the second rate there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cubic<T> {
    /// The weights of the change of the value, of the first rate and of the last rate.
    weights: Signal<[T; 3]>,
}

impl<T: Scalar> Cubic<T> {
    /// The place at a time `t` after the first of two instants, which are `dt`, not zero, apart.
    pub fn at(t: T, dt: T) -> Self {
        let [one, two, three, six] = [1.0, 2.0, 3.0, 6.0].map(T::constant);
        let s = t / dt;
        let rest = one - s;
        Self {
            weights: Signal {
                value: [
                    s * s * (three - two * s),
                    s * rest * rest * dt,
                    -(s * s * rest * dt),
                ],
                rate: [
                    six * s * rest / dt,
                    rest * (one - three * s),
                    s * (three * s - two),
                ],
                second_rate: [
                    six * (rest - s) / (dt * dt),
                    (six * s - two * two) / dt,
                    (six * s - two) / dt,
                ],
            },
        }
    }

    /// The same place on a straight line, which is a cubic too: the rates at the ends do not matter.
    fn on_line(t: T, dt: T) -> Self {
        let [zero, one] = [T::zero(), T::one()];
        Self {
            weights: Signal {
                value: [t / dt, zero, zero],
                rate: [one / dt, zero, zero],
                second_rate: [zero; 3],
            },
        }
    }

    fn between<V, S>(&self, from: &Signal<S>, to: &Signal<S>) -> Signal<S>
    where
        S: Values<V>,
        V: Copy
            + Default
            + core::ops::Add<Output = V>
            + core::ops::Sub<Output = V>
            + core::ops::Mul<T, Output = V>,
    {
        let weighed = |[change, first, last]: [T; 3], at: S| {
            let ends = from.value.values().zip(to.value.values());
            let rates = from.rate.values().zip(to.rate.values());
            let each = at.values().zip(ends).zip(rates);
            S::from_values(each.map(|((at, (start, end)), (first_rate, last_rate))| {
                at + (end - start) * change + first_rate * first + last_rate * last
            }))
        };
        let nothing = S::from_values([]);
        Signal {
            value: weighed(self.weights.value, from.value),
            rate: weighed(self.weights.rate, nothing),
            second_rate: weighed(self.weights.second_rate, nothing),
        }
    }
}

/// The weights of values and rates at both ends of a step of length `dt`, at a time `t` after its start.
type Interpolation<T> = fn(T, T) -> Cubic<T>;

impl<T: Real> Tracker<T> {
    /// Makes one step of length `dt` between two inputs that may lie far apart, in as many sub-steps as the bounds on
    /// corrections require, at most [`max_steps`](Self::max_steps). `motion` is the motion at `from`. Between the
    /// ends, drives and chassis points follow the cubics that have their values and rates there. If these lead
    /// nowhere, as after a wrong rate or over a long step, they follow straight lines, in at most
    /// [`max_steps`](Self::max_steps) further sub-steps. The result has the rates of `to`.
    ///
    /// A step with `dt` zero, for example in a simulator that pauses, is not divided: it begins at the last position,
    /// goes to inputs that lie near the last ones, and finds their rates.
    ///
    /// # Errors
    ///
    /// As [`advance`](Self::advance), with the times counted from the start of the step; the motion is then
    /// unchanged. The error is the one on the cubics.
    pub fn step_between<L, C, const N: usize>(
        &self,
        linkage: &L,
        [from, to]: [&Inputs<C, L::Drives>; 2],
        dt: T,
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, Stopped<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: Between<T, L::Fixed>,
    {
        let along = |curve: Interpolation<T>, mut next: Motion<T, N>| {
            let mut inputs = *from;
            let advanced = self.advance_along(curve, linkage, &mut inputs, to, dt, &mut next)?;
            Ok((next, advanced))
        };
        // From rest, in the same assembly: the last rates led the cubics astray.
        let (next, advanced) = along(Cubic::at, *motion)
            .or_else(|failed| along(Cubic::on_line, motion.stopped()).map_err(|_| failed))?;
        *motion = next;
        Ok(advanced)
    }

    /// As [`step_between`](Self::step_between) along the cubics alone, but if it stops early it keeps the progress:
    /// `inputs`, those of `motion`, move with it.
    ///
    /// # Errors
    ///
    /// As [`advance`](Self::advance), with the times counted from the start; motion and inputs are then
    /// those at [`Stopped::reached`].
    pub fn advance_between<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: &mut Inputs<C, L::Drives>,
        to: &Inputs<C, L::Drives>,
        dt: T,
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, Stopped<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: Between<T, L::Fixed>,
    {
        self.advance_along(Cubic::at, linkage, inputs, to, dt, motion)
    }

    /// The same along other curves.
    fn advance_along<L, C, const N: usize>(
        &self,
        curve: Interpolation<T>,
        linkage: &L,
        inputs: &mut Inputs<C, L::Drives>,
        to: &Inputs<C, L::Drives>,
        dt: T,
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, Stopped<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: Between<T, L::Fixed>,
    {
        let from = *inputs;
        if dt == T::zero() {
            let report = self.step_at_once(linkage, [&from, to], motion)?;
            *inputs = *to;
            return Ok(report);
        }
        let at = |t: T| {
            if t == dt {
                return *to;
            }
            let cubic = curve(t, dt);
            Inputs {
                chassis: from.chassis.between(&to.chassis, &cubic),
                drives: cubic.between(&from.drives, &to.drives),
            }
        };
        let advanced = self.advance(linkage, at, T::zero(), dt, motion);
        match &advanced {
            Ok(_) => *inputs = *to,
            // At the start the second rates are those of the caller and not of the cubic.
            Err(stopped) if stopped.reached == T::zero() => {}
            Err(stopped) => *inputs = at(stopped.reached),
        }
        advanced
    }

    /// A step of zero length, which has no rates between its ends.
    fn step_at_once<L, C, const N: usize>(
        &self,
        linkage: &L,
        ends: [&Inputs<C, L::Drives>; 2],
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, Stopped<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let [from, to] = ends.map(|inputs| Prescribed::new(linkage, inputs));
        let dt = T::zero();
        let change = Change {
            from: Some(&from),
            to: &to,
            dt,
        };
        let stepped = self.step_on_the_way::<_, C, N>(linkage, &change, motion);
        stepped.map_err(|error| Stopped {
            reached: dt,
            refused: Some((dt, error)),
        })
    }
}
