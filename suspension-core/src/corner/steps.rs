//! The steps of a corner.

use super::clock::Clock;
use super::{Corner, drives};
use crate::arithmetic::scalar::Real;
use crate::error::{Failure, SolveError};
use crate::linkage::Linkage;
use crate::signal::{Inputs, Signal};
use crate::solve::report::Report;
use crate::step::substeps::Stopped;

impl<T: Real, L: Linkage<N, Scalar = T>, const N: usize> Corner<L, N> {
    /// Makes one step of length `dt` to the values and rates that the drives have at its end, however far these are
    /// from the last ones. The corner stays in the assembly to which a motion between both ends leads; if that motion
    /// locks, the step is refused.
    ///
    /// A step that is too long is divided. The drives then follow cubics between its ends or, if these lead past a
    /// lock (as after a wrong rate or a long pause), straight lines. A step that is not divided considers only its
    /// end: drives that pass a lock and come back within the step are followed.
    ///
    /// Velocities and accelerations follow from the given rates: with [`Signal::still`] the wheel is at rest at the
    /// end, wherever it came from. With `dt` zero, for example in a simulator that pauses, the drives must be near
    /// the last ones. A negative `dt` leads back in time.
    ///
    /// ```
    /// use suspension_core::Signal;
    /// use suspension_core::linkages::double_wishbone::{Corner, Drives};
    ///
    /// let mut corner: Corner = Corner::design()?;
    /// let rest = corner.drives();
    /// // A loop at 1 kHz: travel and its rates come from the vehicle's equations of motion.
    /// for tick in 1..=100 {
    ///     let (sine, cosine) = f64::sin_cos(0.02 * f64::from(tick));
    ///     let drives = Signal {
    ///         value: Drives { bump: rest.bump + 0.03 * sine, ..rest },
    ///         rate: Drives { bump: 0.6 * cosine, steer: 0.0 },
    ///         second_rate: Drives { bump: -12.0 * sine, steer: 0.0 },
    ///     };
    ///     corner.step(1e-3, drives)?;
    /// }
    /// let points = corner.points();
    /// assert!((points.rate.wheel_centre.z - 0.6 * f64::cos(2.0)).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// See [`Stopped`], with times on the clock of [`Corner::time`]; the corner is then unchanged. If the mechanism locks, the
    /// unknown that is named there is the one that moves farthest at the lock; the program's `range` says which link is too long
    /// or too short to go on. Detecting a lock takes 500 to 2,000 times as long as a step of a millisecond, half as much in
    /// [`step_towards`](Self::step_towards); a refusal by [`Bounded::attempt`](crate::Bounded::attempt) takes no longer than a
    /// step.
    pub fn step(
        &mut self,
        dt: T,
        drives: Signal<L::Drives>,
    ) -> Result<Report<T>, Failure<Stopped<T>, L::Listing>> {
        let ends = [&Inputs::still(self.drives), &Inputs::still(drives)];
        let stepped = self.check(&drives, dt).and_then(|()| {
            let motion = &mut self.motion;
            self.tracker.step_between(&self.model, ends, dt, motion)
        });
        let report = stepped.map_err(|stopped| {
            let reached = self.time() + stopped.reached;
            let stopped = Stopped { reached, ..stopped };
            stopped.named(self.model.listing())
        })?;
        self.drives = drives;
        self.clock.advance(dt);
        Ok(report)
    }

    /// Follows drives that are functions of time up to the time `to`, in as few steps as succeed; the drives within a
    /// step are not considered. `to` is a time on the clock of [`Corner::time`], not a duration: a corner that is
    /// already there does not move. The functions must continue from the present drives: a jump at the start, which
    /// [`Corner::step`] would follow, may be refused. Driven angles must stay within their range, which is checked
    /// only at the end.
    ///
    /// # Errors
    ///
    /// See [`Stopped`]; the corner then stands at [`Stopped::reached`], which is the lock if a drive locks. At the
    /// lock itself velocities are unbounded, so a step may lead neither on nor back from there: to go back, use a
    /// copy of the corner made before.
    pub fn advance(
        &mut self,
        to: T,
        drives: impl Fn(T) -> Signal<L::Drives>,
    ) -> Result<Report<T>, Failure<Stopped<T>, L::Listing>> {
        let (from, start) = (self.time(), self.drives);
        let at = |time: T| if time == from { start } else { drives(time) };
        let inputs = |time| Inputs::still(at(time));
        let advanced = drives::check(&self.model, &at(to), [from, to]).and_then(|()| {
            let motion = &mut self.motion;
            self.tracker.advance(&self.model, inputs, from, to, motion)
        });
        self.clock = Clock::at(match &advanced {
            Ok(_) => to,
            Err(stopped) => stopped.reached,
        });
        self.drives = at(self.time());
        advanced.map_err(|stopped| stopped.named(self.model.listing()))
    }

    /// A [`step`](Self::step) that goes as far as it can: if a drive locks on the way, the corner stops there. At the
    /// lock itself velocities are unbounded, so a step may lead neither on nor back from there.
    ///
    /// # Errors
    ///
    /// See [`Stopped`], with times on the clock of [`Corner::time`]; the corner then stands at [`Stopped::reached`].
    pub fn step_towards(
        &mut self,
        dt: T,
        drives: Signal<L::Drives>,
    ) -> Result<Report<T>, Failure<Stopped<T>, L::Listing>> {
        let (mut inputs, to) = (Inputs::still(self.drives), Inputs::still(drives));
        let advanced = self.check(&drives, dt).and_then(|()| {
            let motion = &mut self.motion;
            self.tracker
                .advance_between(&self.model, &mut inputs, &to, dt, motion)
        });
        self.drives = inputs.drives;
        self.clock.advance(match &advanced {
            Ok(_) => dt,
            Err(stopped) => stopped.reached,
        });
        let reached = self.time();
        advanced.map_err(|stopped| {
            let stopped = Stopped { reached, ..stopped };
            stopped.named(self.model.listing())
        })
    }

    /// Refuses wrong drives, and a step after which the time is not finite.
    fn check(&self, drives: &Signal<L::Drives>, dt: T) -> Result<(), Stopped<T>> {
        if (self.time() + dt).is_finite() {
            return drives::check(&self.model, drives, [T::zero(), dt]);
        }
        Err(Stopped {
            reached: T::zero(),
            refused: Some((dt, SolveError::StepNotFinite)),
        })
    }
}
