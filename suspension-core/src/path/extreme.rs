//! The places along a curve at which a quantity is largest or smallest.

use crate::arithmetic::scalar::Real;
use crate::linkage::Linkage;
use crate::path::arc::second_order;
use crate::path::configuration::Configuration;
use crate::path::curve::Curve;
use crate::signal::Signal;
use crate::solve::newton::Newton;

/// The number of Newton steps along the curve.
const STEPS: usize = 40;

/// The longest of these steps, as a fraction of the linkage's size.
const LONGEST: f64 = 0.05;

impl<T: Real, L: Linkage<N, Scalar = T>, const N: usize> Curve<'_, L, N> {
    /// The nearest place along the curve where a quantity turns, with the curve's derivatives there, and the
    /// quantity's extreme value. Uses Newton's method on the quantity's slope, which takes the curve's second
    /// derivative. `None` if it does not converge.
    pub(crate) fn extreme(
        &self,
        newton: &Newton<T>,
        from: &Configuration<T, N>,
        forwards: &Configuration<T, N>,
        quantity: impl Fn(&Signal<Configuration<T, N>>) -> Signal<T>,
    ) -> Option<(Signal<Configuration<T, N>>, T)> {
        let size = self.linkage.size();
        let longest = T::constant(LONGEST) * size;
        let half = T::constant(0.5);
        // Near an extreme, the value is off by the square of the distance from it.
        let near = T::EPSILON.sqrt() * T::constant(1e-3) * size;
        let (mut at, mut forwards) = (*from, *forwards);
        for _ in 0..STEPS {
            let parameter = forwards.largest_entry();
            let (corrected, _) = self.correct(newton, at, parameter, longest).ok()?;
            let along = second_order(self, &corrected, parameter, &forwards).ok()?;
            let Signal {
                value,
                rate,
                second_rate,
            } = quantity(&along);
            let step = (-rate / second_rate).max(-longest).min(longest);
            if step.abs() <= near {
                return Some((along, value));
            }
            at = corrected + (along.rate + along.second_rate * (step * half)) * step;
            forwards = along.rate;
        }
        None
    }
}
