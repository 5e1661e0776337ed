//! The leading quantity: its slopes, its target, and where it turns before that.

use crate::arithmetic::magnitude::index_of_largest;
use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::listing::Part;
use crate::path::configuration::Configuration;
use crate::path::led::Led;
use crate::path::led_step::LedStep;
use crate::path::linear::Linear;
use crate::signal::Signal;
use crate::solve::newton::rounding_at;

/// How far the quantity may be from its target, as a multiple of the target's rounding.
const OF_TARGET: f64 = 16.0;

impl<T, L, Q, const N: usize> LedStep<'_, T, L, Q, N>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
    Q: Fn(&Signal<L::Points>) -> Signal<T>,
{
    pub(super) fn value(&self, at: &Configuration<T, N>) -> Result<T, SolveError<T>> {
        let none = Configuration::zero();
        self.number(self.measured(at, none, none).value)
    }

    /// The rate of the quantity when the configuration changes at a rate.
    pub(super) fn slope(
        &self,
        at: &Configuration<T, N>,
        rate: &Configuration<T, N>,
    ) -> Result<T, SolveError<T>> {
        self.number(self.measured(at, *rate, Configuration::zero()).rate)
    }

    /// The largest slope in any direction, which is the norm of the gradient. Multiplied by a tolerance of lengths it
    /// is a tolerance of the quantity, whatever its unit.
    pub(super) fn steepest(&self, at: &Configuration<T, N>) -> Result<T, SolveError<T>> {
        let mut square = T::zero();
        for entry in 0..=N {
            let along = Configuration::zero().with_entry(entry, T::one());
            let slope = self.slope(at, &along)?;
            square += slope * slope;
        }
        Ok(square.sqrt())
    }

    /// The [`steepest`](Self::steepest) slope at a position that solves the equations within `tolerance`; `None` if
    /// the quantity does not meet its target there. The quantity may be off by the effect of the tolerance along the
    /// curve, or by the rounding errors of the positions and of the quantity itself.
    pub(super) fn steepest_on_target(
        &self,
        at: &Configuration<T, N>,
        linear: &Linear<L, N>,
        tolerance: T,
    ) -> Result<Option<T>, SolveError<T>> {
        let steepest = self.steepest(at)?;
        let off_target = (self.value(at)? - self.target.value).abs();
        let slope = self.slope(at, &linear.tangent)?.abs() / linear.tangent.norm();
        let rounding = rounding_at(self.curve.linkage, &at.unknowns);
        let near = (tolerance * slope).max(rounding * steepest * T::constant(4.0))
            + T::constant(OF_TARGET) * T::EPSILON * self.target.value.abs();
        Ok((off_target <= near).then_some(steepest))
    }

    /// The turning point of the quantity, if it lies near the last motion and before the target.
    pub(super) fn turning_before(&self, led: &Led<T, N>) -> Option<SolveError<T>> {
        let from = led.configuration.value;
        let forwards = Configuration::zero().with_entry(led.parameter, T::one());
        let (place, extreme) =
            self.curve
                .extreme(&self.leader.newton, &from, &forwards, |along| {
                    (self.quantity)(&self.curve.moving_points(along))
                })?;
        let asked = self.target.value;
        let here = self.value(&from).ok()?;
        // This near to the extreme, the slope is lost in rounding.
        let rounding = T::EPSILON * self.curve.linkage.size();
        let near = rounding * T::constant(1024.0) * self.steepest(&from).ok()?;
        let short = if here < extreme {
            extreme - asked
        } else {
            asked - extreme
        };
        let is_beyond = short <= near;
        let part = Part::Unknown(index_of_largest(&place.rate.unknowns));
        is_beyond.then_some(SolveError::TurningPoint {
            part,
            asked,
            extreme,
        })
    }

    /// A value, target or slope of the quantity, if it is finite. An error names the free drive, for which the
    /// quantity stands in.
    pub(super) fn number(&self, number: T) -> Result<T, SolveError<T>> {
        if number.is_finite() {
            Ok(number)
        } else {
            let part = Part::Drive(self.curve.drive);
            Err(SolveError::NotFinite { part })
        }
    }

    fn measured(
        &self,
        at: &Configuration<T, N>,
        rate: Configuration<T, N>,
        second_rate: Configuration<T, N>,
    ) -> Signal<T> {
        (self.quantity)(&self.curve.moving_points(&Signal {
            value: *at,
            rate,
            second_rate,
        }))
    }
}
