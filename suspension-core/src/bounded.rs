//! A step of fixed cost: one factorisation, a fixed number of solutions, no branch on the data.
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
//! Each is solved by a fixed number of sweeps that put the last value in on the right. The first
//! values of `v` and `a` are the rates of the prediction, corrected by what `e` tells of the term
//! that the prediction lacks: with a prediction of order `p` it grows as `dt^(p + 1)`.

use core::marker::PhantomData;

use nalgebra::SVector;

use crate::entrywise::{difference, minus_multiple, sum};
use crate::error::SolveError;
use crate::factored::{is_healthy, smallest_pivot, with_pivoting};
use crate::linkage::{Factors, Linkage};
use crate::magnitude::sum_of_squares;
use crate::motion::{Motion, Prescribed, input_terms};
use crate::scalar::{Real, Scalar};
use crate::signal::{ChassisMotion, Inputs};

mod judge;
mod predict;

pub use judge::{Measures, Refusal, Settled};
use predict::Prediction;

/// See [`Bounded::tolerance`]: the norm of fifteen residuals that [`Newton`](crate::Newton) would
/// just accept.
const DEFAULT_TOLERANCE: f64 = 64.0;

/// Which rates a step solves for. What it does not solve for it estimates from what it does: good
/// for the next prediction, not for reading off.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outputs {
    /// The position alone.
    Position,
    /// Position and velocity.
    Velocity,
    /// Position, velocity and acceleration.
    Acceleration,
}

/// How to step at a fixed cost: with `SWEEPS` solutions for each of position, velocity and
/// acceleration, 1 or more, from a prediction of order `ORDER`: 0 is the last position, 1 adds its
/// velocity, 2 its acceleration. More sweeps allow for longer steps.
///
/// The instructions that a step executes do not depend on its data, as long as the pivots of the
/// macro's order are healthy and the step is accepted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounded<T, const SWEEPS: usize = 1, const ORDER: usize = 2> {
    /// The largest norm of the residual that is accepted, as a multiple of rounding: it is compared
    /// with `tolerance * EPSILON * size of the linkage`.
    pub tolerance: T,
    /// See [`Tracker::correction_of_move`](crate::Tracker::correction_of_move).
    pub correction_of_move: T,
    /// See [`Tracker::correction_of_size`](crate::Tracker::correction_of_size).
    pub correction_of_size: T,
}

impl<T: Real, const SWEEPS: usize, const ORDER: usize> Default for Bounded<T, SWEEPS, ORDER> {
    fn default() -> Self {
        Self {
            tolerance: T::constant(DEFAULT_TOLERANCE),
            correction_of_move: T::constant(0.1),
            correction_of_size: T::constant(0.02),
        }
    }
}

impl<T: Real, const SWEEPS: usize, const ORDER: usize> Bounded<T, SWEEPS, ORDER> {
    /// One step of length `dt` to the configuration of `inputs`, with velocity and acceleration.
    ///
    /// Where the pivots of the macro's order are unhealthy the step is made again with partial
    /// pivoting.
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
    ) -> Result<Settled<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        self.step_to(Outputs::Acceleration, linkage, inputs, dt, motion)
    }

    /// [`step`](Self::step), solving only for what is asked.
    ///
    /// # Errors
    ///
    /// See [`SolveError`]; the motion is then unchanged.
    #[inline(always)]
    pub fn step_to<L, C, const N: usize>(
        &self,
        outputs: Outputs,
        linkage: &L,
        inputs: &Inputs<C, L::Drives>,
        dt: T,
        motion: &mut Motion<T, N>,
    ) -> Result<Settled<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let prescribed = Prescribed::new(linkage, inputs);
        let step = Step::<L, C, N, SWEEPS, ORDER>::new(linkage, &prescribed, motion, dt);
        let (next, measures) = step.in_fixed_order(outputs);
        let before = motion.positive_determinant;
        // Distances and reasons are for the cold way: what this one keeps to itself stays in
        // registers.
        match self.judge(linkage.size(), &measures, before, T::zero) {
            Ok(settled) if measures.is_healthy() => {
                *motion = measures.signed(next);
                Ok(settled)
            }
            _ => self.step_anew(outputs, linkage, inputs, dt, motion),
        }
    }

    /// The step from the start again: with partial pivoting where that is needed, with the distance
    /// that it goes, or with the reason why it is refused.
    #[cold]
    #[inline(never)]
    fn step_anew<L, C, const N: usize>(
        &self,
        outputs: Outputs,
        linkage: &L,
        inputs: &Inputs<C, L::Drives>,
        dt: T,
        motion: &mut Motion<T, N>,
    ) -> Result<Settled<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let prescribed = Prescribed::new(linkage, inputs);
        let step = Step::<L, C, N, SWEEPS, ORDER>::new(linkage, &prescribed, motion, dt);
        let (at, fixed) = (&step.prediction.position, &prescribed.fixed.value);
        let factors = linkage.factor(at, fixed);
        // Numbers that are none have no pivots either, but that is not what is wrong with them.
        let (next, measures) = if is_healthy(factors.growth_squared()) || !step.starts_finite() {
            step.settle(&factors, outputs)
        } else {
            let lu = with_pivoting(linkage, at, fixed, smallest_pivot())?;
            step.settle(&lu, outputs)
        };
        let before = motion.positive_determinant;
        match self.judge(linkage.size(), &measures, before, || step.moved(&next)) {
            Ok(settled) => {
                *motion = measures.signed(next);
                Ok(settled)
            }
            Err(refusal) => Err(step.explain(self, refusal, &next, &measures)),
        }
    }
}

/// A step on its way, over any numbers: nothing here compares.
#[derive(Clone, Copy, Debug)]
pub struct Step<
    'a,
    L: Linkage<N>,
    C,
    const N: usize,
    const SWEEPS: usize = 1,
    const ORDER: usize = 2,
> {
    linkage: &'a L,
    chassis: PhantomData<C>,
    prescribed: &'a Prescribed<L::Fixed, L::Drives>,
    from: &'a Motion<L::Scalar, N>,
    prediction: Prediction<L::Scalar, N, ORDER>,
}

impl<'a, L, C, const N: usize, const SWEEPS: usize, const ORDER: usize>
    Step<'a, L, C, N, SWEEPS, ORDER>
where
    L: Linkage<N>,
    C: ChassisMotion<L::Fixed>,
{
    /// Predicts the position after `dt`.
    #[inline(always)]
    pub fn new(
        linkage: &'a L,
        prescribed: &'a Prescribed<L::Fixed, L::Drives>,
        from: &'a Motion<L::Scalar, N>,
        dt: L::Scalar,
    ) -> Self {
        Self {
            linkage,
            chassis: PhantomData,
            prescribed,
            from,
            prediction: Prediction::new(from, dt),
        }
    }

    /// The motion in the macro's order of pivots, and what to judge it by.
    #[inline(always)]
    pub fn in_fixed_order(&self, outputs: Outputs) -> (Motion<L::Scalar, N>, Measures<L::Scalar>) {
        let at = &self.prediction.position;
        let factors = self.linkage.factor(at, &self.prescribed.fixed.value);
        self.settle(&factors, outputs)
    }

    #[inline(always)]
    fn settle<F: Factors<L::Scalar, N>>(
        &self,
        factors: &F,
        outputs: Outputs,
    ) -> (Motion<L::Scalar, N>, Measures<L::Scalar>) {
        let (error, residual) = self.error(factors);
        let position = difference(&self.prediction.position, &error);
        let (velocity, acceleration) = self.rates(factors, outputs, &position, &error);
        let measures = Measures {
            residual_squared: sum_of_squares(residual.data.0[0]),
            error_squared: sum_of_squares(error.data.0[0]),
            rates_squared: sum_of_squares(acceleration.data.0[0]),
            growth_squared: factors.growth_squared(),
            determinant_sign: factors.determinant_sign(),
        };
        let motion = Motion {
            position,
            velocity,
            acceleration,
            positive_determinant: None,
        };
        (motion, measures)
    }
}

impl<L, C, const N: usize, const SWEEPS: usize, const ORDER: usize> Step<'_, L, C, N, SWEEPS, ORDER>
where
    L: Linkage<N>,
    C: ChassisMotion<L::Fixed>,
{
    /// The error of the prediction, and the residual that is left without it.
    #[inline(always)]
    fn error<F: Factors<L::Scalar, N>>(
        &self,
        factors: &F,
    ) -> (SVector<L::Scalar, N>, SVector<L::Scalar, N>) {
        let half = L::Scalar::constant(0.5);
        let Prescribed { fixed, drives } = self.prescribed;
        let at = &self.prediction.position;
        let residual = self.linkage.residual(at, &fixed.value, &drives.value);
        let mut right = residual;
        let mut error = factors.solve(&right);
        for _ in 1..SWEEPS {
            right = minus_multiple(&residual, &self.curvature(&error, &error), -half);
            error = factors.solve(&right);
        }
        // F(q0 - e) = F(q0) - J e + C(e, e) / 2, and J e is what was on the right.
        let quadratic = minus_multiple(&residual, &self.curvature(&error, &error), -half);
        (error, difference(&quadratic, &right))
    }

    /// Velocity and acceleration at `position`.
    #[inline(always)]
    fn rates<F: Factors<L::Scalar, N>>(
        &self,
        factors: &F,
        outputs: Outputs,
        position: &SVector<L::Scalar, N>,
        error: &SVector<L::Scalar, N>,
    ) -> (SVector<L::Scalar, N>, SVector<L::Scalar, N>) {
        let Prescribed { fixed, drives } = self.prescribed;
        let inputs = |fixed_rate: &L::Fixed, drive_rate: &L::Drives| {
            input_terms::<L, C, N>(self.linkage, position, &fixed.value, fixed_rate, drive_rate)
        };
        if outputs == Outputs::Position {
            let velocity = self.prediction.velocity_from_positions(error);
            let acceleration = self.prediction.mean_acceleration(self.from, &velocity);
            return (velocity, acceleration);
        }
        let terms = inputs(&fixed.rate, &drives.rate);
        let mut velocity = self.prediction.velocity(error);
        for _ in 0..SWEEPS {
            velocity = factors.solve(&sum(&terms, &self.curvature(error, &velocity)));
        }
        if outputs == Outputs::Velocity {
            let acceleration = self.prediction.mean_acceleration(self.from, &velocity);
            return (velocity, acceleration);
        }
        let rate = &fixed.rate;
        let quadratic = self.linkage.curvature(&velocity, rate, &velocity, rate);
        let terms = difference(&inputs(&fixed.second_rate, &drives.second_rate), &quadratic);
        let mut acceleration = self.prediction.acceleration(error);
        for _ in 0..SWEEPS {
            acceleration = factors.solve(&sum(&terms, &self.curvature(error, &acceleration)));
        }
        (velocity, acceleration)
    }

    /// `C(v, w)` of changes that leave the chassis where it is.
    #[inline(always)]
    fn curvature(
        &self,
        v: &SVector<L::Scalar, N>,
        w: &SVector<L::Scalar, N>,
    ) -> SVector<L::Scalar, N> {
        let at_rest = L::Fixed::default();
        self.linkage.curvature(v, &at_rest, w, &at_rest)
    }
}
