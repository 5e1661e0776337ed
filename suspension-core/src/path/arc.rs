//! The curve near one of its points, as a polynomial in the local parameter.

use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::path::configuration::Configuration;
use crate::path::curve::Curve;
use crate::path::linear::Linear;
use crate::signal::Signal;
use crate::step::series::{Jet, half_curvature};

/// The curve near a configuration: a polynomial in the distance that entry `parameter` has moved, measured along the
/// tangent that the arc was given.
///
/// With `y(s) = sum y_k s^k` the equations, which are quadratic, hold to order `k` if
/// `M y_k = -1/2 sum C(y_i, y_{k-i})`, where `M` is the matrix of the local parametrisation and the parameter's entry
/// of `y_k` is zero from `k = 2` on. Each order takes one back-substitution.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arc<T, const N: usize, const K: usize> {
    pub(crate) jet: Jet<Configuration<T, N>, K>,
    pub(crate) parameter: usize,
}

impl<T: Real, const N: usize, const K: usize> Arc<T, N, K> {
    pub(crate) fn new<L: Linkage<N, Scalar = T>>(
        curve: &Curve<'_, L, N>,
        at: &Configuration<T, N>,
        linear: &Linear<L, N>,
        forwards: &Configuration<T, N>,
    ) -> Self {
        let parameter = linear.parameter;
        let sign = if forwards.entry(parameter) < T::zero() {
            -T::one()
        } else {
            T::one()
        };
        let first = linear.tangent * sign;
        let mut jet = Jet::constant(*at, Configuration::zero());
        let mut unknowns = [first.unknowns; K];
        let mut fixed = [curve.drive_share(first.drive); K];
        for index in 0..K {
            let term = if index == 0 {
                first
            } else {
                let known = unknowns.get(..index).unwrap_or_default();
                let right = -half_curvature(curve.linkage, known, &fixed);
                linear.solve(&right)
            };
            let places = (
                jet.terms.get_mut(index),
                unknowns.get_mut(index),
                fixed.get_mut(index),
            );
            if let (Some(place), Some(unknowns), Some(fixed)) = places {
                *place = term;
                *unknowns = term.unknowns;
                *fixed = curve.drive_share(term.drive);
            }
        }
        Self { jet, parameter }
    }

    /// The configuration at a distance and its derivatives there.
    pub(crate) fn at(&self, distance: T) -> Signal<Configuration<T, N>> {
        self.jet
            .evaluate(distance, Configuration::zero(), |a, b, s| a + b * s)
    }

    /// The derivative of the drive's coordinate at a distance.
    pub(crate) fn drive_rate(&self, distance: T) -> T {
        let mut order = T::constant(K as f64);
        let mut rate = T::zero();
        for term in self.jet.terms.iter().rev() {
            rate = rate * distance + term.drive * order;
            order -= T::one();
        }
        rate
    }

    /// The size of the last term at a distance of 1.
    pub(crate) fn last_term(&self) -> T {
        let last = self.jet.terms.last();
        last.map_or(T::zero(), Configuration::norm)
    }
}

/// The curve's first two derivatives with respect to the local parameter at a configuration.
pub(crate) fn second_order<T: Real, L: Linkage<N, Scalar = T>, const N: usize>(
    curve: &Curve<'_, L, N>,
    at: &Configuration<T, N>,
    parameter: usize,
    forwards: &Configuration<T, N>,
) -> Result<Signal<Configuration<T, N>>, SolveError<T>> {
    let linear = curve.linear(at, parameter)?;
    let arc: Arc<T, N, 2> = Arc::new(curve, at, &linear, forwards);
    Ok(arc.at(T::zero()))
}
