//! The quantity that leads, and its slopes.

use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::listing::Part;
use crate::path::configuration::Configuration;
use crate::path::course::Course;
use crate::signal::Signal;

impl<T, L, Q, const N: usize> Course<'_, T, L, Q, N>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
    Q: Fn(&Signal<L::Points>) -> Signal<T>,
{
    pub(super) fn value(&self, at: &Configuration<T, N>) -> Result<T, SolveError<T>> {
        let none = Configuration::zero();
        self.number(self.measured(at, none, none).value)
    }

    /// The rate of the quantity where the configuration changes at a rate.
    pub(super) fn slope(
        &self,
        at: &Configuration<T, N>,
        rate: &Configuration<T, N>,
    ) -> Result<T, SolveError<T>> {
        self.number(self.measured(at, *rate, Configuration::zero()).rate)
    }

    /// The largest slope in any direction, the norm of the gradient. What lengths are compared
    /// with is, times this, what the quantity and its slope are compared with, whatever its unit.
    pub(super) fn steepest(&self, at: &Configuration<T, N>) -> Result<T, SolveError<T>> {
        let mut square = T::zero();
        for entry in 0..=N {
            let along = Configuration::zero().with_entry(entry, T::one());
            let slope = self.slope(at, &along)?;
            square += slope * slope;
        }
        Ok(square.sqrt())
    }

    /// A value, target or slope of the quantity, which stands in for the free drive, where it is
    /// finite.
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
