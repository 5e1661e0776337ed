//! A step of two corrections with the same factors.

use nalgebra::SVector;

use super::Tracker;
use super::guard::{Change, is_beyond_doubt};
use crate::arithmetic::entrywise::difference;
use crate::arithmetic::magnitude::{largest, magnitude};
use crate::arithmetic::pivot::is_healthy;
use crate::arithmetic::scalar::Real;
use crate::linkage::{Factors, Linkage};
use crate::model::handedness::{count_mirrored, is_right};
use crate::signal::ChassisMotion;
use crate::solve::motion::{Motion, Prescribed, Rates};
use crate::solve::newton::rounding_at;
use crate::solve::report::Report;

impl<T: Real> Tracker<T> {
    /// Makes the step if two corrections with the same factors meet every condition, as in most steps of a control
    /// loop.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn try_two_corrections<L, C, const N: usize>(
        &self,
        linkage: &L,
        change: &Change<'_, L, N>,
        motion: &Motion<T, N>,
    ) -> Option<(Motion<T, N>, Report<T>)>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let Change { to, dt, .. } = *change;
        let Prescribed { fixed, drives } = to;
        let residual_at = |q: &SVector<T, N>| linkage.residual(q, &fixed.value, &drives.value);
        let predicted = motion.predict(dt);
        let factors = linkage.factor(&predicted, &fixed.value);
        let error = factors.solve(&residual_at(&predicted));
        // The second correction removes the error of second order that the first has left.
        let nearly = difference(&predicted, &error);
        let second = factors.solve(&residual_at(&nearly));
        let position = difference(&nearly, &second);
        let left = residual_at(&position);
        let last = linkage.factor(&position, &fixed.value);
        let next = Rates::<L, C, N>::new(linkage, to, &position, &last).motion();
        let (residual, error) = (magnitude(&left).ok()?, magnitude(&error).ok()?);
        let rounding = rounding_at(linkage, &position);
        let tolerance = self.newton.tolerance.length(rounding);
        let [moves] = difference(&predicted, &motion.position).data.0;
        let moved = largest(moves);
        let bound = self.correction_bound(moved, linkage.size());
        let [second] = second.data.0;
        let contracts = self.newton.contraction.is_none_or(|contraction| {
            largest(second) <= (contraction * error).max(rounding * T::constant(1024.0))
        });
        let next = next.ok()?;
        let is_same_assembly = motion.positive_determinant.is_none()
            || motion.positive_determinant == next.positive_determinant;
        let is_good = residual <= tolerance
            && error <= bound
            && is_beyond_doubt(error.max(change.jump::<C>(linkage)), moved, linkage.size())
            && contracts
            && is_same_assembly
            && is_right(count_mirrored(linkage, &position, &fixed.value))
            && is_healthy(factors.growth_squared())
            && is_healthy(last.growth_squared());
        is_good.then(|| {
            let report = Report {
                tolerance,
                residual_squared: residual * residual,
                error_squared: error * error,
                growth_squared: last.growth_squared(),
                steps: 1,
                iterations: 1,
            };
            (next, report)
        })
    }
}
