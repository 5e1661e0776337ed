//! Prescribed inputs: drives and chassis points, each with its rates.

mod number;

use crate::arithmetic::scalar::Real;
use crate::values::Values;

pub use number::Number;

/// A prescribed quantity at one instant, with its first and second time derivative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Signal<V> {
    /// The value.
    pub value: V,
    /// Its first derivative with respect to time, per second.
    pub rate: V,
    /// Its second derivative with respect to time, per second squared.
    pub second_rate: V,
}

impl<V> Signal<V> {
    /// Applies a linear function to the quantity and its derivatives.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn map<U>(&self, linear: impl Fn(&V) -> U) -> Signal<U> {
        Signal {
            value: linear(&self.value),
            rate: linear(&self.rate),
            second_rate: linear(&self.second_rate),
        }
    }

    /// Sets a part of this quantity.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn set<U>(&mut self, quantity: Signal<U>, part: impl Fn(&mut V) -> &mut U) {
        *part(&mut self.value) = quantity.value;
        *part(&mut self.rate) = quantity.rate;
        *part(&mut self.second_rate) = quantity.second_rate;
    }
}

impl<V: Default> Signal<V> {
    /// A quantity at rest.
    pub fn still(value: V) -> Self {
        Self {
            value,
            rate: V::default(),
            second_rate: V::default(),
        }
    }

    /// A quantity that starts at a value and changes at a constant rate, after a time.
    pub fn line<T: Real>(start: V, rate: V, time: T) -> Self
    where
        V: Values<T>,
    {
        let pairs = start.values().zip(rate.values());
        let value = V::from_values(pairs.map(|(start, rate)| start + rate * time));
        Self {
            value,
            rate,
            second_rate: V::default(),
        }
    }
}

/// The inputs of a step: drives and chassis points, each with its rates.
///
/// The type of `chassis` chooses the code: with [`Still`] no term of a moving chassis is compiled in; with
/// `Signal<Fixed<T>>` each chassis point has its own position, velocity and acceleration, in the axes of the
/// hardpoints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inputs<C, D> {
    /// The motion of the chassis points.
    pub chassis: C,
    /// The drives, in metres (or the unit of the hardpoints) and radians.
    pub drives: Signal<D>,
}

impl<D> Inputs<Still, D> {
    /// Inputs with the chassis points at rest at their positions in the model.
    pub fn still(drives: Signal<D>) -> Self {
        Self {
            chassis: Still,
            drives,
        }
    }
}

/// A chassis whose points rest at their positions in the model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Still;

/// The motion of the chassis points `F`.
pub trait ChassisMotion<F>: Copy {
    /// Whether undriven chassis points have any velocity or acceleration.
    const MOVES: bool;

    /// Positions and rates, given the positions `rest` in the model.
    fn signal(&self, rest: &F) -> Signal<F>;
}

impl<F: Copy + Default> ChassisMotion<F> for Still {
    const MOVES: bool = false;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn signal(&self, rest: &F) -> Signal<F> {
        Signal {
            value: *rest,
            rate: F::default(),
            second_rate: F::default(),
        }
    }
}

impl<F: Copy> ChassisMotion<F> for Signal<F> {
    const MOVES: bool = true;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn signal(&self, _rest: &F) -> Signal<F> {
        *self
    }
}
