//! A quantity near an instant, as a polynomial in time.

use core::ops::Add;

use nalgebra::{SVector, Vector3};

use crate::arithmetic::scalar::Scalar;
use crate::linkage::Values;
use crate::signal::Signal;

/// A quantity near an instant: `value + terms[0] dt + terms[1] dt^2 + ...`, with `K` terms, where `dt` is the time
/// from that instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet<V, const K: usize> {
    /// The quantity at the instant.
    pub value: V,
    /// Its Taylor coefficients of order 1 to `K`: `terms[k - 1]` is the `k`-th derivative with
    /// respect to time, divided by `k!`.
    pub terms: [V; K],
}

impl<V: Copy, const K: usize> Jet<V, K> {
    /// A constant quantity, with the zero of its kind.
    pub(crate) fn constant(value: V, zero: V) -> Self {
        Self {
            value,
            terms: [zero; K],
        }
    }

    /// The coefficients of order 0 to `order - 1`.
    pub(super) fn below(&self, order: usize) -> impl DoubleEndedIterator<Item = &V> {
        let terms = self.terms.get(..order.saturating_sub(1));
        core::iter::once(&self.value).chain(terms.unwrap_or_default())
    }

    /// Value and rates at `dt` by Horner's rule; `plus(a, b, s)` is `a + b s`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn evaluate<T: Scalar>(
        &self,
        dt: T,
        zero: V,
        plus: impl Fn(V, V, T) -> V,
    ) -> Signal<V> {
        let [mut value, mut rate, mut half_second] = [zero; 3];
        let descending = self.terms.iter().rev().chain([&self.value]);
        for coefficient in descending {
            half_second = plus(rate, half_second, dt);
            rate = plus(value, rate, dt);
            value = plus(*coefficient, value, dt);
        }
        Signal {
            value,
            rate,
            second_rate: plus(half_second, half_second, T::one()),
        }
    }
}

impl<S, const K: usize> Jet<S, K> {
    /// The polynomial of second order with the value and rates of a signal, for use where no higher derivatives are
    /// known.
    pub fn of_signal<V: Quantity>(signal: &Signal<S>) -> Self
    where
        S: Values<V>,
    {
        let zero = S::from_values([]);
        let half = signal
            .second_rate
            .map(|v| v.times(V::Number::constant(0.5)));
        Self {
            value: signal.value,
            terms: core::array::from_fn(|index| match index {
                0 => signal.rate,
                1 => half,
                _ => zero,
            }),
        }
    }

    /// Value and rates at the time `dt` from the instant.
    pub fn signal<V: Quantity>(&self, dt: V::Number) -> Signal<S>
    where
        S: Values<V>,
    {
        let zero = S::from_values([]);
        self.evaluate(dt, zero, |a, b, s| a.combined(&b, |a, b| a + b.times(s)))
    }
}

impl<T: Scalar, const N: usize, const K: usize> Jet<SVector<T, N>, K> {
    /// Value and rates at the time `dt` from the instant.
    #[inline]
    pub(super) fn at(&self, dt: T) -> Signal<SVector<T, N>> {
        self.evaluate(dt, SVector::zeros(), |a, b, s| a + b * s)
    }
}

/// The entries of drives and points: numbers and vectors.
pub trait Quantity: Copy + Default + Add<Output = Self> {
    /// The number type.
    type Number: Scalar;

    /// A multiple of it.
    fn times(self, factor: Self::Number) -> Self;
}

impl<T: Scalar> Quantity for T {
    type Number = T;

    fn times(self, factor: T) -> T {
        self * factor
    }
}

impl<T: Scalar> Quantity for Vector3<T> {
    type Number = T;

    fn times(self, factor: T) -> Self {
        self * factor
    }
}
