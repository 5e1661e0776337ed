//! One step, generic over numbers.

use core::marker::PhantomData;

use nalgebra::SVector;

use super::Outputs;
use super::evidence::Evidence;
use super::predict::Prediction;
use crate::arithmetic::entrywise::{difference, plus_multiple, sum};
use crate::arithmetic::magnitude::sum_of_squares;
use crate::arithmetic::scalar::Scalar;
use crate::linkage::{Factors, Linkage};
use crate::model::handedness::count_mirrored;
use crate::signal::ChassisMotion;
use crate::solve::motion::{Motion, Prescribed, input_terms};

/// A step before it is judged, over any numbers including lanes: nothing here compares.
#[derive(Clone, Copy, Debug)]
pub struct Step<
    'a,
    L: Linkage<N>,
    C,
    const N: usize,
    const CORRECTIONS: usize = 1,
    const ORDER: usize = 2,
> {
    pub(super) linkage: &'a L,
    chassis: PhantomData<C>,
    pub(super) prescribed: &'a Prescribed<L::Fixed, L::Drives>,
    pub(super) from: &'a Motion<L::Scalar, N>,
    pub(super) prediction: Prediction<L::Scalar, N, ORDER>,
}

impl<'a, L, C, const N: usize, const CORRECTIONS: usize, const ORDER: usize>
    Step<'a, L, C, N, CORRECTIONS, ORDER>
where
    L: Linkage<N>,
    C: ChassisMotion<L::Fixed>,
{
    /// Predicts the position after `dt`.
    #[cfg_attr(not(debug_assertions), inline(always))]
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

    /// The motion in the macro's order of pivots, and the evidence to judge it by.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn in_fixed_order(&self, outputs: Outputs) -> (Motion<L::Scalar, N>, Evidence<L::Scalar>) {
        let at = &self.prediction.position;
        let factors = self.linkage.factor(at, &self.prescribed.fixed.value);
        self.settle::<_, false>(&factors, outputs)
    }

    /// The motion with any factors of the Jacobian at the prediction. The equations are either written out wherever
    /// they are evaluated, which is fast, or `CALLED`, which is short.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn settle<F: Factors<L::Scalar, N>, const CALLED: bool>(
        &self,
        factors: &F,
        outputs: Outputs,
    ) -> (Motion<L::Scalar, N>, Evidence<L::Scalar>) {
        let (error, residual_squared) = self.error::<_, CALLED>(factors);
        let position = difference(&self.prediction.position, &error);
        let (velocity, acceleration) = self.rates::<_, CALLED>(factors, outputs, &position, &error);
        let evidence = Evidence {
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
        (motion, evidence)
    }
}

impl<L, C, const N: usize, const CORRECTIONS: usize, const ORDER: usize>
    Step<'_, L, C, N, CORRECTIONS, ORDER>
where
    L: Linkage<N>,
    C: ChassisMotion<L::Fixed>,
{
    /// The error of the prediction, and the square of the residual that is left after it is subtracted.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn error<F: Factors<L::Scalar, N>, const CALLED: bool>(
        &self,
        factors: &F,
    ) -> (SVector<L::Scalar, N>, L::Scalar) {
        let half = L::Scalar::constant(0.5);
        let at = &self.prediction.position;
        let residual = if CALLED {
            self.residual_called(at)
        } else {
            self.residual(at)
        };
        let mut error = factors.solve(&residual);
        if CORRECTIONS == 0 {
            // What is left, C(e, e) / 2, is below the error as long as the error is below the shortest length over
            // the root of N.
            let bound = sum_of_squares(error.data.0[0]);
            return (error, bound);
        }
        // F(q0 - e) = F(q0) - J e + C(e, e) / 2: the first solution leaves the last term, each later one the change
        // of that term.
        let mut curvature = self.change_of_jacobian::<CALLED>(&error, &error);
        let mut left = curvature;
        for _ in 1..CORRECTIONS {
            error = factors.solve(&plus_multiple(&residual, &curvature, half));
            let before = curvature;
            curvature = self.change_of_jacobian::<CALLED>(&error, &error);
            left = difference(&curvature, &before);
        }
        (error, sum_of_squares(left.data.0[0]) * half * half)
    }

    /// Velocity and acceleration at `position`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rates<F: Factors<L::Scalar, N>, const CALLED: bool>(
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
        let velocity = self.rate::<_, CALLED>(factors, &terms, error, first);
        if outputs == Outputs::Velocity {
            let acceleration = self.prediction.mean_acceleration(self.from, &velocity);
            return (velocity, acceleration);
        }
        let rate = &fixed.rate;
        let quadratic = self.curvature::<CALLED>(&velocity, rate, &velocity, rate);
        let terms = difference(&inputs(&fixed.second_rate, &drives.second_rate), &quadratic);
        let first = self.prediction.acceleration(error);
        let acceleration = self.rate::<_, CALLED>(factors, &terms, error, first);
        (velocity, acceleration)
    }

    /// The solution of `J(q0 - e) rate = terms`, corrected from a first value.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rate<F: Factors<L::Scalar, N>, const CALLED: bool>(
        &self,
        factors: &F,
        terms: &SVector<L::Scalar, N>,
        error: &SVector<L::Scalar, N>,
        first: SVector<L::Scalar, N>,
    ) -> SVector<L::Scalar, N> {
        if CORRECTIONS == 0 {
            return factors.solve(terms);
        }
        let mut rate = first;
        for _ in 0..CORRECTIONS {
            let change = self.change_of_jacobian::<CALLED>(error, &rate);
            rate = factors.solve(&sum(terms, &change));
        }
        rate
    }

    /// `C(v, w)` for changes that leave the chassis where it is.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn change_of_jacobian<const CALLED: bool>(
        &self,
        v: &SVector<L::Scalar, N>,
        w: &SVector<L::Scalar, N>,
    ) -> SVector<L::Scalar, N> {
        let at_rest = L::Fixed::default();
        self.curvature::<CALLED>(v, &at_rest, w, &at_rest)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn curvature<const CALLED: bool>(
        &self,
        v: &SVector<L::Scalar, N>,
        v_fixed: &L::Fixed,
        w: &SVector<L::Scalar, N>,
        w_fixed: &L::Fixed,
    ) -> SVector<L::Scalar, N> {
        if CALLED {
            self.curvature_called(v, v_fixed, w, w_fixed)
        } else {
            self.linkage.curvature(v, v_fixed, w, w_fixed)
        }
    }

    #[cold]
    #[inline(never)]
    fn curvature_called(
        &self,
        v: &SVector<L::Scalar, N>,
        v_fixed: &L::Fixed,
        w: &SVector<L::Scalar, N>,
        w_fixed: &L::Fixed,
    ) -> SVector<L::Scalar, N> {
        self.linkage.curvature(v, v_fixed, w, w_fixed)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn residual(&self, at: &SVector<L::Scalar, N>) -> SVector<L::Scalar, N> {
        let Prescribed { fixed, drives } = self.prescribed;
        self.linkage.residual(at, &fixed.value, &drives.value)
    }

    #[cold]
    #[inline(never)]
    pub(super) fn residual_called(&self, at: &SVector<L::Scalar, N>) -> SVector<L::Scalar, N> {
        self.residual(at)
    }
}
