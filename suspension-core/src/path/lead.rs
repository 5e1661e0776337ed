//! Change of drive: a motion led by any quantity of the points, in place of one of the drives.
//!
//! The curve `F(x) = 0` has the entries `x = (q, h)`, one of which is its local parameter. `M` is the Jacobian with that
//! entry held, `e` the correction without it, and `y` the tangent whose entry there is 1. A Newton step on `F(x) = 0`,
//! `g(x) = target` is
//!
//! ```text
//! M e = F,   dx = -e + y (target - g + g' e) / (g' y),
//! ```
//!
//! and velocity and acceleration follow from the rates of the target in the same way: the rate of `g` is affine
//! in the velocities, and its second rate in the accelerations.

use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::{Linkage, Values};
use crate::listing::Kind;
use crate::path::curve::Curve;
use crate::path::leader::Leader;
use crate::path::led::Led;
use crate::path::led_step::LedStep;
use crate::signal::{ChassisMotion, Inputs, Signal};
use crate::solve::report::Report;
use crate::step::substeps::{Stopped, advance_in_steps};

/// The measure of the listing with this index as a quantity that leads, chosen at run time among
/// [`Linkage::Measures`]; `None` if there is none.
pub fn measured<T, L, const N: usize>(
    linkage: &L,
    index: usize,
) -> Option<impl Fn(&Signal<L::Points>) -> Signal<T> + Copy>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
{
    let exists = index < linkage.count(Kind::Measure);
    exists.then_some(move |points: &Signal<L::Points>| {
        let measures = linkage.measures(points);
        measures.map(|measures| measures.values().nth(index).unwrap_or_default())
    })
}

impl<T: Real> Leader<T> {
    /// Makes one step of length `dt` to where `quantity` meets `target`, predicted from the last motion. The free
    /// drive's signal in `inputs` is ignored.
    ///
    /// `quantity` computes a quantity with its first and second rate from the points and their rates. Like all such
    /// rates, they must be linear in the velocities, and in the accelerations apart from terms of the velocities.
    ///
    /// # Errors
    ///
    /// [`SolveError::TurningPoint`] if the quantity turns before it meets the target,
    /// [`SolveError::CrossedSingularity`] if another singularity lies in between, [`SolveError::NotFinite`] of the
    /// free drive if the quantity or its target is NaN or infinite, otherwise as
    /// [`Tracker::step`](crate::Tracker::step). The motion is then unchanged.
    pub fn step<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: &Inputs<C, L::Drives>,
        quantity: impl Fn(&Signal<L::Points>) -> Signal<T>,
        target: &Signal<T>,
        dt: T,
        led: &mut Led<T, N>,
    ) -> Result<Report<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let step = LedStep {
            leader: self,
            curve: Curve::with_free_drive(linkage, inputs, led.drive),
            quantity,
            target,
        };
        step.number(target.value)?;
        match step.make::<C>(dt, led).map_err(|error| error.of_step(dt)) {
            Ok((next, report)) => {
                *led = next;
                Ok(report)
            }
            Err(error @ (SolveError::NotFinite { .. } | SolveError::StepNotFinite)) => Err(error),
            Err(error) => Err(step.turning_before(led).unwrap_or(error)),
        }
    }

    /// Follows the motion from time `from` to time `to`, in either direction, in as few steps as the bounds on
    /// corrections allow: a refused step is halved, and from the second good one in a row on the step is doubled.
    ///
    /// # Errors
    ///
    /// [`Stopped`] if steps have shrunk to rounding or `max_steps` are used up; the motion is then the last good one.
    pub fn advance<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: impl Fn(T) -> Inputs<C, L::Drives>,
        quantity: impl Fn(&Signal<L::Points>) -> Signal<T>,
        target: impl Fn(T) -> Signal<T>,
        [from, to]: [T; 2],
        led: &mut Led<T, N>,
    ) -> Result<Report<T>, Stopped<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let advanced = advance_in_steps([from, to], self.max_steps, |next, dt| {
            self.step(linkage, &inputs(next), &quantity, &target(next), dt, led)
        });
        let ends = [from, to].map(|time| target(time).value);
        advanced.map_err(|stopped| asked_at_end(stopped, ends))
    }
}

/// A stop at a turning point with the target of the end in place of that of the last halved step, if the extreme value
/// lies before it.
fn asked_at_end<T: Real>(mut stopped: Stopped<T>, [start, end]: [T; 2]) -> Stopped<T> {
    if let Some((_, SolveError::TurningPoint { asked, extreme, .. })) = &mut stopped.refused
        && (end - *extreme) * (*extreme - start) > T::zero()
    {
        *asked = end;
    }
    stopped
}
