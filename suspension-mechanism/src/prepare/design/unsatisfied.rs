//! The equations that the points of a file do not satisfy.

use nalgebra::SVector;

/// An equation that points do not satisfy.
#[derive(Clone, Copy)]
pub(crate) struct Unsatisfied {
    pub(crate) equation: usize,
    /// Its residual, in the unit of lengths.
    pub(crate) by: f64,
}

/// The fraction of the mechanism's size below which points satisfy an equation.
const ROUNDING: f64 = 1e-9;

/// The difference below which sizes are equal, as a fraction of the largest.
const EQUAL: f64 = 1e-6;

impl Unsatisfied {
    /// The equation with the largest residual; `None` if the points satisfy all.
    pub(crate) fn find<const N: usize>(residual: &SVector<f64, N>, size: f64) -> Option<Self> {
        let (equation, by) = largest(residual.abs().as_slice())?;
        (by > ROUNDING * size).then_some(Self { equation, by })
    }
}

/// The number of the largest size, and the size; if several are equal to rounding, such as those of two sides, the
/// first.
pub(crate) fn largest(sizes: &[f64]) -> Option<(usize, f64)> {
    let most = sizes.iter().copied().fold(0.0, f64::max);
    let mut numbered = sizes.iter().copied().enumerate();
    numbered.find(|(_, size)| *size >= (1.0 - EQUAL) * most)
}
