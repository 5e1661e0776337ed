//! A moving suspension: its model, configuration, drives and time in one value.

mod clock;
mod drives;

use crate::arithmetic::scalar::Real;
use crate::directions::Directions;
use crate::error::{Failure, GeometryError, SolveError};
use crate::linkage::{Build, Designed, Linkage};
use crate::signal::{Inputs, Signal, Still};
use crate::solve::assemble::assemble;
use crate::solve::motion::Motion;
use crate::solve::newton::Newton;
use crate::solve::report::Report;
use crate::statics::Statics;
use crate::step::substeps::Stopped;
use crate::step::tracker::Tracker;
use crate::values::Values;
use crate::wheel::{Kingpin, Wheel};
use clock::Clock;

/// A suspension on a chassis at rest: its model, configuration, drives and time. For a moving chassis see
/// [`chassis`](crate::chassis).
///
/// `linkage!` defines a `Corner` for each listing, so that a program writes `double_wishbone::Corner`. Failures name
/// the parts concerned; after a failure the corner stands where the last good step has led it. Points and rates have
/// the unit and the axes of the hardpoints, angles are in radians, time is in seconds.
///
/// ```
/// use suspension_core::Signal;
/// use suspension_core::linkages::double_wishbone_pushrod::{Corner, Drives};
///
/// let mut corner: Corner = Corner::design()?; // the hardpoints that the listing states
/// let start = corner.drives();
/// let rate = Drives { bump: 0.05, ..Drives::default() };
/// corner.advance(0.5, |time| Signal::line(start, rate, time))?;
/// let camber = corner.wheel().map(|wheel| wheel.camber);
/// assert!(camber.is_some_and(|camber| camber < 0.0)); // the top of the wheel leans inboard in bump
/// let per_bump = corner.per(Drives { bump: 1.0, ..Drives::default() })?;
/// assert!(per_bump.measures.rate.damper < 0.0); // the motion ratio: the damper gets shorter
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
pub struct Corner<L: Linkage<N>, const N: usize>
where
    L::Scalar: Real,
{
    /// The settings of the corner's steps.
    pub tracker: Tracker<L::Scalar>,
    model: L,
    motion: Motion<L::Scalar, N>,
    drives: Signal<L::Drives>,
    clock: Clock<L::Scalar>,
}

/// Points and measures with their derivatives with respect to the change of drives that was given to [`Corner::per`],
/// instead of time derivatives.
#[derive(Clone, Copy)]
pub struct Derivatives<L: Linkage<N>, const N: usize> {
    /// Value, first and second derivative of every point.
    pub points: Signal<L::Points>,
    /// Value, first and second derivative of every measure.
    pub measures: Signal<L::Measures>,
}

impl<L: Build<N, Scalar: Real, Listing: Default>, const N: usize> Corner<L, N> {
    /// A corner at rest at the points that the listing states: see [`Corner::new`].
    ///
    /// # Errors
    ///
    /// See [`Build::of`].
    pub fn design() -> Result<Self, Failure<GeometryError, L::Listing>>
    where
        L: Designed<N>,
    {
        Self::new(&L::design())
    }

    /// A corner at rest at the given points, which give links and bodies their lengths. The points need not satisfy
    /// what else the listing states, for example that a point lies on the line of a `slide`: they are used as given
    /// until the first step, which moves them to where they do. [`Corner::assembled`] moves them at once.
    ///
    /// # Errors
    ///
    /// See [`Build::of`].
    pub fn new(points: &L::Points) -> Result<Self, Failure<GeometryError, L::Listing>> {
        match L::new(points) {
            Ok(model) => Ok(Self::of(model, points)),
            Err(error) => Err(error.named(L::Listing::default())),
        }
    }
}

impl<T: Real, L: Build<N, Scalar = T>, const N: usize> Corner<L, N> {
    /// A corner at rest at the given points, with a model that was built from them; for any other model see
    /// [`Corner::assembled`].
    pub fn of(model: L, points: &L::Points) -> Self {
        Self {
            tracker: Tracker::default(),
            motion: Motion::at_rest(model.unknowns(points)),
            drives: Signal::still(model.drives_at(points)),
            clock: Clock::at(T::zero()),
            model,
        }
    }

    /// A corner at rest with a model whose lengths are not those of the points. The drives have the values that the
    /// points give, and the configuration is the one nearest to the points.
    ///
    /// # Errors
    ///
    /// As [`assemble()`].
    pub fn assembled(
        model: L,
        points: &L::Points,
    ) -> Result<Self, Failure<SolveError<T>, L::Listing>> {
        let mut corner = Self::of(model, points);
        let inputs = Inputs::still(corner.drives);
        let unknowns = &mut corner.motion.position;
        match assemble(&Newton::from_afar(), &corner.model, &inputs, unknowns) {
            Ok(_) => Ok(corner),
            Err(error) => Err(error.named(corner.model.listing())),
        }
    }
}

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
    /// the last ones.
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
    /// See [`Stopped`], with times from the start of the step; the corner is then unchanged. Detecting that a
    /// mechanism locks takes about two hundred times as long as a step.
    pub fn step(
        &mut self,
        dt: T,
        drives: Signal<L::Drives>,
    ) -> Result<Report<T>, Failure<Stopped<T>, L::Listing>> {
        let ends = [&Inputs::still(self.drives), &Inputs::still(drives)];
        let stepped = drives::check(&self.model, &drives, [T::zero(), dt]).and_then(|()| {
            let motion = &mut self.motion;
            self.tracker.step_between(&self.model, ends, dt, motion)
        });
        let report = stepped.map_err(|stopped| stopped.named(self.model.listing()))?;
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
    /// See [`Stopped`], with times from the start of the step; the corner then stands at
    /// [`Stopped::reached`].
    pub fn step_towards(
        &mut self,
        dt: T,
        drives: Signal<L::Drives>,
    ) -> Result<Report<T>, Failure<Stopped<T>, L::Listing>> {
        let (mut inputs, to) = (Inputs::still(self.drives), Inputs::still(drives));
        let advanced = drives::check(&self.model, &drives, [T::zero(), dt]).and_then(|()| {
            let motion = &mut self.motion;
            self.tracker
                .advance_between(&self.model, &mut inputs, &to, dt, motion)
        });
        self.drives = inputs.drives;
        self.clock.advance(match &advanced {
            Ok(_) => dt,
            Err(stopped) => stopped.reached,
        });
        advanced.map_err(|stopped| stopped.named(self.model.listing()))
    }

    /// Points and measures with their derivatives for the change of drives `change`. If one drive has 1 in `change`
    /// and the others 0, these are the motion ratios and how they change. The corner may be at rest.
    ///
    /// # Errors
    ///
    /// [`SolveError::Singular`] if the drives lock.
    pub fn per(
        &self,
        change: L::Drives,
    ) -> Result<Derivatives<L, N>, Failure<SolveError<T>, L::Listing>> {
        let position = &self.motion.position;
        let derived = Directions::at(&self.model, self.drives.value, position, |directions| {
            directions.points(change)
        });
        let points = derived.map_err(|error| error.named(self.model.listing()))?;
        Ok(Derivatives {
            measures: self.model.measures(&points),
            points,
        })
    }

    /// The corner in its present configuration, at rest, ready to be loaded with forces.
    ///
    /// # Errors
    ///
    /// [`SolveError::Singular`] if the drives lock.
    pub fn statics(&self) -> Result<Statics<'_, L, N>, Failure<SolveError<T>, L::Listing>> {
        let statics = Statics::new(&self.model, self.drives.value, &self.motion.position);
        statics.map_err(|error| error.named(self.model.listing()))
    }

    /// Positions, velocities and accelerations of all points, by name.
    pub fn points(&self) -> Signal<L::Points> {
        let inputs: Inputs<Still, _> = Inputs::still(self.drives);
        self.motion.points(&self.model, &inputs)
    }

    /// The measures of the listing, by name, with their time derivatives.
    pub fn measures(&self) -> Signal<L::Measures> {
        self.model.measures(&self.points())
    }

    /// The wheel, or the first of several; `None` if the listing states none.
    pub fn wheel(&self) -> Option<Wheel<T>> {
        let axis = self.model.wheel_axis(&self.points().value)?;
        Wheel::of(axis)
    }

    /// The kingpin of that wheel; `None` if the listing states none.
    pub fn kingpin(&self) -> Option<Kingpin<T>> {
        let points = self.points().value;
        let axis = self.model.wheel_axis(&points)?;
        Some(Kingpin::of(self.model.kingpin(&points)?, axis))
    }

    /// The wheel with this name, and its kingpin if the listing states one; `None` if there is no such wheel. A wheel
    /// that is stated without a name has the empty name.
    pub fn wheel_named(&self, name: &str) -> Option<(Wheel<T>, Option<Kingpin<T>>)> {
        let mut wheels = (0..).map_while(|wheel| self.model.wheel(wheel));
        let wheel = wheels.find(|wheel| wheel.name == name)?;
        let points = self.points().value;
        let axis = points.at(wheel.axis);
        let kingpin = wheel.kingpin.map(|ends| Kingpin::of(points.at(ends), axis));
        Some((Wheel::of(axis)?, kingpin))
    }

    /// The values of the drives.
    pub fn drives(&self) -> L::Drives {
        self.drives.value
    }

    /// The time, counted from zero when the corner was made.
    pub fn time(&self) -> T {
        self.clock.time()
    }

    /// The geometry.
    pub fn model(&self) -> &L {
        &self.model
    }

    /// The unknowns with their rates.
    pub fn motion(&self) -> &Motion<T, N> {
        &self.motion
    }
}
