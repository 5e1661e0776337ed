//! The common interface of the ways to step.

use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::signal::{ChassisMotion, Inputs};
use crate::solve::motion::Motion;
use crate::solve::report::Report;
use crate::step::bounded::Bounded;
use crate::step::series::{InputSeries, Jet, SeriesTracker};
use crate::step::substeps::{MAX_STEPS, advance_in_steps};
use crate::step::tracker::Tracker;

pub use crate::step::substeps::Stopped;

/// A way to step from one motion of a linkage to the next: [`Tracker`], [`Bounded`], [`SeriesTracker`].
///
/// Each judges success by the residual alone, describes what it did in a [`Report`], and leaves the motion unchanged
/// if it fails.
pub trait Stepper<T: Real> {
    /// Makes one step of length `dt` to the configuration of `inputs`, with velocity and acceleration.
    ///
    /// # Errors
    ///
    /// See [`SolveError`]; the motion is then unchanged.
    fn step<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: &Inputs<C, L::Drives>,
        dt: T,
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>;

    /// Goes from one time to another, in either direction, in as few steps as succeed: a refused step is halved, and
    /// from the second good one in a row on the step is doubled.
    ///
    /// # Errors
    ///
    /// [`Stopped`] if steps have shrunk to rounding or are used up; the motion is then the last good one, at
    /// [`Stopped::reached`].
    fn advance<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: impl Fn(T) -> Inputs<C, L::Drives>,
        [from, to]: [T; 2],
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, Stopped<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        advance_in_steps([from, to], MAX_STEPS, |time, dt| {
            self.step(linkage, &inputs(time), dt, motion)
        })
    }
}

impl<T: Real> Stepper<T> for Tracker<T> {
    fn step<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: &Inputs<C, L::Drives>,
        dt: T,
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        Tracker::step(self, linkage, inputs, dt, motion)
    }

    fn advance<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: impl Fn(T) -> Inputs<C, L::Drives>,
        [from, to]: [T; 2],
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, Stopped<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        Tracker::advance(self, linkage, inputs, from, to, motion)
    }
}

impl<T: Real, const CORRECTIONS: usize, const ORDER: usize> Stepper<T>
    for Bounded<T, CORRECTIONS, ORDER>
{
    #[inline]
    fn step<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: &Inputs<C, L::Drives>,
        dt: T,
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        Bounded::step(self, linkage, inputs, dt, motion)
    }
}

/// Uses the series to order `K` that follows from the value and rates of the inputs at the end of the step. With more
/// of their derivatives [`SeriesTracker::step`] takes longer steps.
impl<T: Real, const K: usize> Stepper<T> for SeriesTracker<T, K> {
    fn step<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: &Inputs<C, L::Drives>,
        dt: T,
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        // The inputs at the start, from which the series proceeds.
        let chassis = Jet::<_, 2>::of_signal(&inputs.chassis.signal(linkage.fixed()));
        let drives = Jet::<_, 2>::of_signal(&inputs.drives);
        let series = InputSeries {
            chassis: Jet::of_signal(&chassis.signal(-dt)),
            drives: Jet::of_signal(&drives.signal(-dt)),
        };
        SeriesTracker::step(self, linkage, &series, dt, motion)
    }
}
