//! What the points of a file do not satisfy.

use nalgebra::SVector;

/// An equation that points do not satisfy.
#[derive(Clone, Copy)]
pub(super) struct Unsatisfied {
    pub(super) equation: usize,
    /// Its residual, in the unit of lengths.
    pub(super) by: f64,
}

/// Below this part of the mechanism's size points satisfy an equation.
const ROUNDING: f64 = 1e-9;

impl Unsatisfied {
    /// The equation with the largest residual; `None` where points satisfy all.
    pub(super) fn of<const N: usize>(residual: &SVector<f64, N>, size: f64) -> Option<Self> {
        let equation = residual.iamax();
        let by = residual[equation].abs();
        (by > ROUNDING * size).then_some(Self { equation, by })
    }
}
