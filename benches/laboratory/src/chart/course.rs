//! The motion that all methods follow: instants, and the inputs at them.

use suspension_core::{Scalar, Signal, Values};

use suspension::mechanism::DriveLaws;

/// Evenly spaced instants with the drives' values there, computed once, so that reference and methods use the same numbers.
#[derive(Clone, Debug)]
pub struct Course<D> {
    /// Instants, s.
    pub times: Vec<f64>,
    /// Drives.
    pub drives: Vec<Given<D>>,
    spacing: f64,
}

/// The drives at an instant and their series about it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Given<D> {
    /// Value and rates.
    pub signal: Signal<D>,
    /// Taylor coefficients, order 1 first.
    pub terms: [D; ORDERS],
}

/// The highest order of a series in the chart.
pub const ORDERS: usize = 8;

/// A number this near to a multiple counts as one; a part of the step.
const SLACK: f64 = 1e-6;

impl<D: Values<f64>> Course<D> {
    /// Makes instants `spacing` seconds apart from the first to the last of `ends`, in either direction. A remainder at the
    /// end is omitted.
    pub fn new(laws: &DriveLaws, ends: [f64; 2], spacing: f64) -> Self {
        let [first, last] = ends;
        let count = ((last - first).abs() / spacing + SLACK).floor();
        let step = spacing.copysign(last - first);
        let times: Vec<f64> = (0..=count as usize)
            .map(|index| first + step * index as f64)
            .collect();
        let given = |t: &f64| Given {
            signal: laws.inputs(*t).drives,
            terms: laws.terms(*t),
        };
        let drives = times.iter().map(given).collect();
        Self {
            times,
            drives,
            spacing,
        }
    }

    /// Returns the number of instants in `step` seconds; `None` if `step` is not a multiple of the spacing or longer than
    /// the course.
    pub fn stride(&self, step: f64) -> Option<usize> {
        let stride = (step / self.spacing).round();
        let is_multiple = (step - stride * self.spacing).abs() < SLACK * step;
        let stride = stride as usize;
        (is_multiple && (1..self.times.len()).contains(&stride)).then_some(stride)
    }
}

/// Converts numbers to another type, under the same names.
pub fn cast<T: Scalar, D: Values<f64>, E: Values<T>>(numbers: &D) -> E {
    E::from_values(numbers.values().map(T::constant))
}

/// Converts drives to another number type.
pub fn cast_drives<T: Scalar, D: Values<f64>, E: Values<T>>(drives: &Signal<D>) -> Signal<E> {
    Signal {
        value: cast(&drives.value),
        rate: cast(&drives.rate),
        second_rate: cast(&drives.second_rate),
    }
}
