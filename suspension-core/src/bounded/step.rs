//! One step, over any numbers.

use core::marker::PhantomData;

use nalgebra::SVector;

use super::Outputs;
use super::judge::Measures;
use super::predict::Prediction;
use crate::entrywise::{difference, plus_multiple, sum};
use crate::handedness::count_mirrored;
use crate::linkage::{Factors, Linkage};
use crate::magnitude::sum_of_squares;
use crate::motion::{Motion, Prescribed, input_terms};
use crate::scalar::Scalar;
use crate::signal::ChassisMotion;

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
    pub(super) linkage: &'a L,
    chassis: PhantomData<C>,
    pub(super) prescribed: &'a Prescribed<L::Fixed, L::Drives>,
    pub(super) from: &'a Motion<L::Scalar, N>,
    pub(super) prediction: Prediction<L::Scalar, N, ORDER>,
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
        const { assert!(ORDER <= 2, "of order 0, 1 or 2") };
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

    /// The motion with any factors of the Jacobian at the prediction.
    #[inline(always)]
    pub(super) fn settle<F: Factors<L::Scalar, N>>(
        &self,
        factors: &F,
        outputs: Outputs,
    ) -> (Motion<L::Scalar, N>, Measures<L::Scalar>) {
        let (error, residual_squared) = self.error(factors);
        let position = difference(&self.prediction.position, &error);
        let (velocity, acceleration) = self.rates(factors, outputs, &position, &error);
        let measures = Measures {
            residual_squared,
            error_squared: sum_of_squares(error.data.0[0]),
            rates_squared: sum_of_squares(acceleration.data.0[0]),
            growth_squared: factors.growth_squared(),
            determinant_sign: factors.determinant_sign(),
            mirrored: count_mirrored(self.linkage, &position, &self.prescribed.fixed.value),
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
    /// The error of the prediction, and the square of the residual that is left without it.
    #[inline(always)]
    fn error<F: Factors<L::Scalar, N>>(&self, factors: &F) -> (SVector<L::Scalar, N>, L::Scalar) {
        let half = L::Scalar::constant(0.5);
        let Prescribed { fixed, drives } = self.prescribed;
        let at = &self.prediction.position;
        let residual = self.linkage.residual(at, &fixed.value, &drives.value);
        let mut error = factors.solve(&residual);
        if SWEEPS == 0 {
            // What is left, C(e, e) / 2, is far below the error that `judge` asks for.
            return (error, L::Scalar::default());
        }
        // F(q0 - e) = F(q0) - J e + C(e, e) / 2: of the first solution the last term is left, of
        // each later one what that term changed by.
        let mut curvature = self.curvature(&error, &error);
        let mut left = curvature;
        for _ in 1..SWEEPS {
            error = factors.solve(&plus_multiple(&residual, &curvature, half));
            let before = curvature;
            curvature = self.curvature(&error, &error);
            left = difference(&curvature, &before);
        }
        (error, sum_of_squares(left.data.0[0]) * half * half)
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
        let first = self.prediction.velocity(error);
        let velocity = self.rate(factors, &terms, error, first);
        if outputs == Outputs::Velocity {
            let acceleration = self.prediction.mean_acceleration(self.from, &velocity);
            return (velocity, acceleration);
        }
        let rate = &fixed.rate;
        let quadratic = self.linkage.curvature(&velocity, rate, &velocity, rate);
        let terms = difference(&inputs(&fixed.second_rate, &drives.second_rate), &quadratic);
        let first = self.prediction.acceleration(error);
        let acceleration = self.rate(factors, &terms, error, first);
        (velocity, acceleration)
    }

    /// What solves `J(q0 - e) rate = terms`, from a first value.
    #[inline(always)]
    fn rate<F: Factors<L::Scalar, N>>(
        &self,
        factors: &F,
        terms: &SVector<L::Scalar, N>,
        error: &SVector<L::Scalar, N>,
        first: SVector<L::Scalar, N>,
    ) -> SVector<L::Scalar, N> {
        if SWEEPS == 0 {
            return factors.solve(terms);
        }
        (0..SWEEPS).fold(first, |rate, _| {
            factors.solve(&sum(terms, &self.curvature(error, &rate)))
        })
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
