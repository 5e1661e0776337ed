//! A step of fixed cost: one factorisation, a fixed number of back-substitutions, no branch on the data.
//!
//! `F` is quadratic, so with `J` and `F` at the predicted position `q0 = q + e`
//!
//! ```text
//! F(q0 - e) = F(q0) - J e + C(e, e) / 2        J(q0 - e) = J - C(e, .)        exactly,
//! ```
//!
//! and the error `e` of the prediction, velocity and acceleration all follow with the factors of
//! `J`:
//!
//! ```text
//! J e = F(q0) + C(e, e) / 2
//! J v = -dF/du udot + C(e, v)                                (Attia 2003, eq. 3)
//! J a = -dF/du uddot - C(v, v) + C(e, a)                     (Attia 2003, eq. 7 and 8)
//! ```
//!
//! Each is corrected a fixed number of times, with the last value on the right-hand side. The first values of `v` and
//! `a` are the rates of the prediction, corrected with the information in `e` about the term that the prediction
//! lacks, which grows as `dt^(p + 1)` for a prediction of order `p`. If a drive jumps, `e` has no information about
//! the rates, and a part of it stays in them: of the order of `e^2 / (l dt)` in the velocity and `e^2 / (l dt^2)` in
//! the acceleration, where `l` is the length of a link. In `f64` a step of a millisecond is accepted only if these
//! are below 1e-8 m/s^2; in `f32` steps of a millisecond are accepted with 0.01 m/s and 20 m/s^2. [`Report::error`]
//! is the size of `e`.

use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::signal::{ChassisMotion, Inputs};
use crate::solve::factored::with_pivoting_for_rates;
use crate::solve::motion::{Motion, Prescribed};
use crate::solve::report::Report;
use crate::solve::tolerance::Tolerance;
use crate::step::tracker::{CORRECTION_OF_MOVE, CORRECTION_OF_SIZE};

mod evidence;
mod judge;
mod predict;
mod step;

pub use evidence::Evidence;
pub use judge::Refusal;
pub use step::Step;

/// See [`Bounded::tolerance`]: the norm of fifteen residuals that [`Newton`](crate::Newton) would
/// just accept.
const DEFAULT_TOLERANCE: f64 = 64.0;

/// Which rates a step solves for. The others are estimated from these: good enough for the next prediction, but not
/// as results.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outputs {
    /// The position alone.
    Position,
    /// Position and velocity.
    Velocity,
    /// Position, velocity and acceleration.
    Acceleration,
}

/// Settings for steps at a fixed cost, with `CORRECTIONS` solutions for each of position, velocity and acceleration,
/// from a prediction of order `ORDER`: 0 is the last position, 1 adds its velocity, 2 its acceleration. More
/// corrections allow longer steps.
///
/// With 0 corrections each is solved for once and all terms of `e` are left out, which saves a quarter of the
/// instructions. A step is then accepted only if its error is within the tolerance, so that what is left out is
/// rounding: this holds for `f32` at 1 ms. With a tolerance other than the default, what is left out of the rates grows with it.
///
/// A first step from rest is one with `dt = 0`: it finds velocity and acceleration. It starts from a configuration:
/// where points do not satisfy the listing, for example where one is a tenth of a millimetre off the line of its
/// `slide`, [`Corner::assembled`](crate::Corner::assembled) or [`assemble()`](crate::assemble()) finds it.
///
/// At 1 ms one correction is enough for smooth drives if the acceleration is solved for; otherwise it takes two, or
/// half the step. The page [`controller`](crate::controller#ways-to-step) says how smooth: in `f64` a wheel on a road
/// takes two or three.
///
/// The instructions that a step executes do not depend on its data, as long as the pivots of the fixed order are
/// healthy, the error of the prediction is within [`correction_of_size`](Self::correction_of_size) and the step is
/// accepted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounded<T, const CORRECTIONS: usize = 1, const ORDER: usize = 2> {
    /// The largest norm of the residual that is accepted. Rounding is `EPSILON` times the size of the linkage:
    /// coordinates are assumed to be local ([`local`](crate::model::local)).
    pub tolerance: Tolerance<T>,
    /// See [`Tracker::correction_of_move`](crate::Tracker::correction_of_move).
    pub correction_of_move: T,
    /// See [`Tracker::correction_of_size`](crate::Tracker::correction_of_size).
    pub correction_of_size: T,
}

/// One correction from a prediction of second order; for other settings see [`Bounded::new`].
impl<T: Real> Default for Bounded<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Real, const CORRECTIONS: usize, const ORDER: usize> Bounded<T, CORRECTIONS, ORDER> {
    /// Settings with the corrections and the order of prediction that the type states: `Bounded::<f32, 0>::new()`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn new() -> Self {
        Self {
            tolerance: Tolerance::Roundings(T::constant(DEFAULT_TOLERANCE)),
            correction_of_move: T::constant(CORRECTION_OF_MOVE),
            correction_of_size: T::constant(CORRECTION_OF_SIZE),
        }
    }

    /// Makes one step of length `dt` to the configuration of `inputs`, with velocity and acceleration.
    ///
    /// If the pivots of the macro's order are unhealthy, the step is made again with partial pivoting.
    ///
    /// # Errors
    ///
    /// See [`SolveError`]; the motion is then unchanged.
    #[inline]
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
        self.step_to(Outputs::Acceleration, linkage, inputs, dt, motion)
    }

    /// As [`step`](Self::step), but solves only for the requested outputs.
    ///
    /// # Errors
    ///
    /// See [`SolveError`]; the motion is then unchanged.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn step_to<L, C, const N: usize>(
        &self,
        outputs: Outputs,
        linkage: &L,
        inputs: &Inputs<C, L::Drives>,
        dt: T,
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        match self.attempt(outputs, linkage, inputs, dt, motion) {
            Ok(settled) => Ok(settled),
            Err(_) => self.step_anew(outputs, linkage, inputs, dt, motion),
        }
    }

    /// As [`step_to`](Self::step_to), but only in the macro's order of pivots: the call for a hard real-time loop. A
    /// refusal takes no longer than a step, and brings neither partial pivoting nor the search for reasons into the
    /// program; if it is to be explained, there is time for `step_to`.
    ///
    /// # Errors
    ///
    /// [`Refusal`]; the motion is then unchanged. An error of the prediction is [`Diverging`](Refusal::Diverging) by
    /// its size alone, however far the step goes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn attempt<L, C, const N: usize>(
        &self,
        outputs: Outputs,
        linkage: &L,
        inputs: &Inputs<C, L::Drives>,
        dt: T,
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, Refusal>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let prescribed = Prescribed::new(linkage, inputs);
        let step = Step::<L, C, N, CORRECTIONS, ORDER>::new(linkage, &prescribed, motion, dt);
        let (next, evidence) = step.in_fixed_order(outputs);
        let before = motion.positive_determinant;
        // The step's own values stay in registers: the distance it goes is not asked for.
        let settled = self.judge(linkage.size(), &evidence, before, T::zero)?;
        if !evidence.is_healthy() {
            return Err(Refusal::Unhealthy);
        }
        *motion = evidence.signed(next);
        Ok(settled)
    }

    /// Makes the step again from the start with partial pivoting, and returns the distance that it goes or the reason
    /// why it is refused. Uses little code and stack: time no longer matters here.
    #[cold]
    #[inline(never)]
    fn step_anew<L, C, const N: usize>(
        &self,
        outputs: Outputs,
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
        let step = Step::<L, C, N, CORRECTIONS, ORDER>::new(linkage, &prescribed, motion, dt);
        let (at, fixed) = (&step.prediction.position, &prescribed.fixed.value);
        // NaN is the reason even if the pivots are too small as well.
        let start = step.residual_called(at);
        if let Some(equation) = start.iter().position(|x| !x.is_finite()) {
            return Err(SolveError::not_finite(equation).of_step(dt));
        }
        let (next, evidence) =
            with_pivoting_for_rates(linkage, at, fixed, |lu| step.settle::<_, true>(lu, outputs))?;
        let before = motion.positive_determinant;
        match self.judge(linkage.size(), &evidence, before, || step.moved(&next)) {
            Ok(settled) => {
                *motion = evidence.signed(next);
                Ok(settled)
            }
            Err(refusal) => Err(step.explain(self, refusal, &next, &evidence).of_step(dt)),
        }
    }
}
