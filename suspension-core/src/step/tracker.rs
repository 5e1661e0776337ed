//! Following a motion in time: from the last good motion to the next.

mod between;
pub(crate) mod guard;
mod two_corrections;

use crate::arithmetic::magnitude::{index_of_largest, largest};
use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::listing::Part;
use crate::model::handedness;
use crate::signal::{ChassisMotion, Inputs};
use crate::solve::factored::with_factors_for_rates;
use crate::solve::motion::{Motion, Prescribed, Rates};
use crate::solve::newton::Newton;
use crate::solve::report::Report;
use crate::step::substeps::{MAX_STEPS, Stopped, advance_in_steps};

pub use between::{Between, Cubic};
use guard::{Change, Crossing};

/// See [`Tracker::correction_of_move`].
pub(crate) const CORRECTION_OF_MOVE: f64 = 0.1;

/// See [`Tracker::correction_of_size`].
pub(crate) const CORRECTION_OF_SIZE: f64 = 0.02;

/// Settings for following a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tracker<T> {
    /// The settings with which each step is solved.
    pub newton: Newton<T>,
    /// The number of steps that one advance may try, including refused ones.
    pub max_steps: usize,
    /// The largest first correction of a predicted position, as a fraction of the predicted move. A larger one shows
    /// that the prediction has left the motion, and the root may belong to another motion.
    pub correction_of_move: T,
    /// The correction that is allowed in any case, as a fraction of the linkage's size: for drives that jump, and for
    /// the first step from rest.
    pub correction_of_size: T,
    /// The largest `|w| / |d|` of a step `d` of the unknowns, where `w` solves `J w = C(d, d)` and `C(d, .)` is the
    /// change of the Jacobian over the step. If it is larger, singularities may lie in between, possibly an even number
    /// of them.
    pub change_of_jacobian: T,
}

impl<T: Real> Default for Tracker<T> {
    fn default() -> Self {
        Self {
            newton: Newton::near_by(),
            max_steps: MAX_STEPS,
            correction_of_move: T::constant(CORRECTION_OF_MOVE),
            correction_of_size: T::constant(CORRECTION_OF_SIZE),
            change_of_jacobian: T::constant(guard::CHANGE_OF_JACOBIAN),
        }
    }
}

impl<T: Real> Tracker<T> {
    /// Makes one step of length `dt` to the configuration of `inputs`, predicted from the last motion.
    ///
    /// Chassis points, including driven ones, are assumed to have moved as their rates in `inputs` say, because the
    /// inputs of the last motion are not known here. If their values jump without rates, call
    /// [`step_between`](Self::step_between), which sees the jump and refuses one across a lock.
    ///
    /// # Errors
    ///
    /// See [`SolveError`]; the motion is then unchanged.
    pub fn step<L, C, const N: usize>(
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
        let prescribed = Prescribed::new(linkage, inputs);
        let change = Change {
            from: None,
            to: &prescribed,
            dt,
        };
        self.step_over::<_, C, N>(linkage, &change, motion)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn step_over<L, C, const N: usize>(
        &self,
        linkage: &L,
        change: &Change<'_, L, N>,
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        if let Some((next, report)) = self.try_two_corrections::<_, C, N>(linkage, change, motion) {
            *motion = next;
            return Ok(report);
        }
        self.by_iteration::<_, C, N>(linkage, change, motion)
    }

    /// The same step, compiled once for all functions of time that [`advance`](Self::advance) is given as inputs.
    #[inline(never)]
    fn step_on_the_way<L, C, const N: usize>(
        &self,
        linkage: &L,
        change: &Change<'_, L, N>,
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        self.step_over::<_, C, N>(linkage, change, motion)
    }

    /// Makes the step with as many iterations as it takes.
    #[cold]
    #[inline(never)]
    fn by_iteration<L, C, const N: usize>(
        &self,
        linkage: &L,
        change: &Change<'_, L, N>,
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let prescribed = change.to;
        let mut position = motion.predict(change.dt);
        let [moves] = (position - motion.position).data.0;
        let bound = self.correction_bound(largest(moves), linkage.size());
        let solved = self
            .newton
            .solve_prescribed(linkage, prescribed, &mut position, Some(bound));
        let report = solved.map_err(|error| error.of_step(change.dt))?;
        handedness::check(linkage, &position, &prescribed.fixed.value)?;
        let moves = &(position - motion.position);
        let before = motion.positive_determinant;
        let fixed = &prescribed.fixed.value;
        *motion = with_factors_for_rates(linkage, &position, fixed, |factors| {
            let next = Rates::<L, C, N>::new(linkage, prescribed, &position, factors).motion()?;
            if before.is_some() && before != next.positive_determinant {
                let part = Part::Unknown(index_of_largest(moves));
                return Err(SolveError::CrossedSingularity { part });
            }
            let crossing = Crossing {
                linkage,
                change,
                moves,
                factors,
            };
            crossing.check::<C>(self.change_of_jacobian)?;
            Ok(next)
        })??;
        Ok(report)
    }

    /// The largest correction permitted for a step with this move.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn correction_bound(&self, moved: T, size: T) -> T {
        (self.correction_of_move * moved).max(self.correction_of_size * size)
    }

    /// Follows the motion from time `from` to time `to`, in either direction, in as few steps as the bounds on
    /// corrections allow: a refused step is halved, and from the second good one in a row on the step is doubled.
    ///
    /// A step into another assembly is refused. If an odd number of singularities lies in between, the sign of the
    /// Jacobian's determinant shows it; otherwise the Jacobian's change over the step does.
    ///
    /// # Errors
    ///
    /// [`Stopped`] if steps have shrunk to rounding or `max_steps` are used up; the motion is then the last good one,
    /// at [`Stopped::reached`].
    pub fn advance<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: impl Fn(T) -> Inputs<C, L::Drives>,
        from: T,
        to: T,
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, Stopped<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let mut last = Prescribed::new(linkage, &inputs(from));
        advance_in_steps([from, to], self.max_steps, |next, dt| {
            let prescribed = Prescribed::new(linkage, &inputs(next));
            let change = Change {
                from: Some(&last),
                to: &prescribed,
                dt,
            };
            let report = self.step_on_the_way::<_, C, N>(linkage, &change, motion)?;
            last = prescribed;
            Ok(report)
        })
    }
}
