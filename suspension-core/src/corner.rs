//! A moving suspension: its model, configuration, drives and time in one value.

mod build;
mod clock;
mod drives;
mod steps;

use nalgebra::SVector;

use crate::arithmetic::scalar::Real;
use crate::directions::Directions;
use crate::error::{Failure, SolveError};
use crate::linkage::Linkage;
use crate::signal::{Inputs, Signal, Still};
use crate::solve::motion::Motion;
use crate::statics::Statics;
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
///
/// A corner is plain data. A copy of it saves its state: the same steps from the copy give the same bits. A simulator
/// resets a corner by a copy that it made before, and moves it elsewhere by a [`step`](Corner::step) of any length
/// above zero. Other hardpoints make another corner, which then steps to the present drives:
///
/// ```
/// use suspension_core::Signal;
/// use suspension_core::linkage::Designed;
/// use suspension_core::linkages::double_wishbone::{Corner, Drives, Model};
///
/// let home: Corner = Corner::design()?;
/// let drives = Drives { bump: 0.34, ..home.drives() };
/// let mut corner = home;
/// corner.step(1.0, Signal::still(drives))?; // 40 mm of bump travel
/// let saved = corner;
///
/// let mut hardpoints = Model::design(); // as drawn, not as they stand in `corner.points()`
/// hardpoints.rack.z += 0.005;
/// let mut changed: Corner = Corner::new(&hardpoints)?;
/// changed.step(1.0, Signal::still(corner.drives()))?;
/// let toe = |corner: Corner| corner.wheel().map_or(0.0, |wheel| wheel.toe.to_degrees());
/// assert_eq!(format!("{:.3}, {:.3} deg", toe(saved), toe(changed)), "-0.188, -0.465 deg");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// The right corner of an axle has the mirrored hardpoints; angles of its wheel have the same signs. A drive along y has the
/// opposite value there, but a rack moves both of its ends by the same amount:
///
/// ```
/// use suspension_core::linkage::Designed;
/// use suspension_core::linkages::double_wishbone::{Corner, Drives, Model};
/// use suspension_core::nalgebra::Vector3;
/// use suspension_core::{Signal, Values};
///
/// let left = Model::<f64>::design();
/// let right = left.map(|at| Vector3::new(at.x, -at.y, at.z));
/// let mut axle: [Corner; 2] = [Corner::new(&left)?, Corner::new(&right)?];
/// let rack = 0.010; // to the left
/// for corner in &mut axle {
///     let design = corner.drives(); // steer: 0.34 and -0.34
///     corner.step(1.0, Signal::still(Drives { steer: design.steer + rack, ..design }))?;
/// }
/// let toe = axle.map(|corner| corner.wheel().map_or(0.0, |wheel| wheel.toe.to_degrees()));
/// assert_eq!(format!("{:.2}, {:.2} deg", toe[0], toe[1]), "-4.80, 4.85 deg"); // both turn left
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// A file stores the state as numbers: the [`motion`](Corner::motion), whose fields are public, the drives with their
/// rates, and the time. [`Corner::resumed`] goes on from there:
///
/// ```
/// use suspension_core::Signal;
/// use suspension_core::linkages::double_wishbone::{Corner, Drives};
///
/// let mut corner: Corner = Corner::design()?;
/// let start = corner.drives();
/// let drives = |time| Signal::line(start, Drives { bump: 0.05, steer: 0.0 }, time);
/// corner.advance(0.5, drives)?;
/// let stored = (*corner.motion(), corner.drive_signal(), corner.time());
///
/// let (motion, signal, time) = stored; // read from the file
/// let mut resumed: Corner = Corner::resumed(*corner.model(), motion, signal, time);
/// resumed.advance(0.8, drives)?;
/// corner.advance(0.8, drives)?;
/// assert_eq!(resumed.motion(), corner.motion());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
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
#[derive(Clone, Copy, Debug)]
pub struct Derivatives<L: Linkage<N>, const N: usize> {
    /// Value, first and second derivative of every point.
    pub points: Signal<L::Points>,
    /// Value, first and second derivative of every measure.
    pub measures: Signal<L::Measures>,
}

impl<T: Real, L: Linkage<N, Scalar = T>, const N: usize> Corner<L, N> {
    /// Points and measures with their derivatives for the change of drives `change`. If one drive has 1 in `change`
    /// and the others 0, these are the motion ratios and how they change. The corner may be at rest. Where a measure
    /// turns back its derivatives are NaN: see [`measure`](crate::model::measure). If the points of a new corner do not
    /// satisfy the listing, the values are those to which the first step moves them.
    ///
    /// # Errors
    ///
    /// [`SolveError::Singular`] if the drives lock, [`SolveError::NotFinite`] if a change is NaN or infinite,
    /// [`SolveError::Overflow`] if a derivative of an unknown is; as [`Tracker::step`] if the points of a new corner are no
    /// configuration and none is near by.
    pub fn per(
        &self,
        change: L::Drives,
    ) -> Result<Derivatives<L, N>, Failure<SolveError<T>, L::Listing>> {
        let derived = drives::check_change(&self.model, &change).and_then(|()| {
            let position = self.configuration()?;
            Directions::at(&self.model, self.drives.value, &position, |directions| {
                directions.points(change)
            })
        });
        let points = derived.map_err(|error| error.named(self.model.listing()))?;
        Ok(Derivatives {
            measures: self.model.measures(&points),
            points,
        })
    }

    /// The corner in its present configuration, at rest, ready to be loaded with forces. If the points of a new corner do
    /// not satisfy the listing, it is the one to which the first step moves them.
    ///
    /// # Errors
    ///
    /// [`SolveError::Singular`] if the drives lock; as [`Tracker::step`] if the points of a new corner are no
    /// configuration and none is near by.
    pub fn statics(&self) -> Result<Statics<'_, L, N>, Failure<SolveError<T>, L::Listing>> {
        let statics = self
            .configuration()
            .and_then(|position| Statics::new(&self.model, self.drives.value, &position));
        statics.map_err(|error| error.named(self.model.listing()))
    }

    /// The position or, where it is none of the linkage, the one to which a step without length leads from it.
    fn configuration(&self) -> Result<SVector<T, N>, SolveError<T>> {
        let inputs: Inputs<Still, _> = Inputs::still(self.drives);
        let mut motion = self.motion;
        let newton = &self.tracker.newton;
        if !newton.is_root(&self.model, &inputs, &motion.position) {
            let no_time = T::zero();
            self.tracker
                .step(&self.model, &inputs, no_time, &mut motion)?;
        }
        Ok(motion.position)
    }

    /// Positions, velocities and accelerations of all points, by name.
    pub fn points(&self) -> Signal<L::Points> {
        let inputs: Inputs<Still, _> = Inputs::still(self.drives);
        self.motion.points(&self.model, &inputs)
    }

    /// The measures of the listing, by name, with their time derivatives, which are NaN where a measure turns back: see
    /// [`measure`](crate::model::measure).
    pub fn measures(&self) -> Signal<L::Measures> {
        self.model.measures(&self.points())
    }

    /// The wheel, or the first of several; `None` if the listing states none.
    pub fn wheel(&self) -> Option<Wheel<T>> {
        let axis = self.model.wheel_axis(&self.points().value)?;
        Wheel::of(axis)
    }

    /// That wheel at these points, with its derivatives: per second if they are those of [`Self::points`], per unit of a change of
    /// the drives if they are those of [`Self::per`], such as camber gain and bump steer. `None` if the listing states no wheel. For
    /// another wheel of an axle see [`Wheel::with_rates`].
    pub fn wheel_rates(&self, points: &Signal<L::Points>) -> Option<Signal<Wheel<T>>> {
        let axis = |points| self.model.wheel_axis(points);
        Wheel::with_rates(&Signal {
            value: axis(&points.value)?,
            rate: axis(&points.rate)?,
            second_rate: axis(&points.second_rate)?,
        })
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

    /// The drives with their rates.
    pub fn drive_signal(&self) -> Signal<L::Drives> {
        self.drives
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
