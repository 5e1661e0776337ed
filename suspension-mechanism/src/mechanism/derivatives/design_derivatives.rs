//! The derivatives of a mechanism with respect to its design.

use nalgebra::Vector3;

/// Points and measures with their derivatives with respect to the drives, or the derivatives of all these along a
/// change of the design.
#[derive(Clone, Debug, Default)]
pub struct Expansion {
    /// The points, or their first or second derivatives with respect to drives, row after row.
    pub points: Vec<Vector3<f64>>,
    /// The measures, then their derivatives with respect to each drive.
    pub measures: Vec<f64>,
}

/// A mechanism at its start, and how it changes with its design.
pub trait DesignDerivatives {
    /// Its points and measures, with their derivatives with respect to the drives.
    fn start(&self) -> &Expansion;

    /// The derivatives of these along a change of points, by number, each with its displacement, and of lengths, each
    /// with its increase; `None` if no such suspensions can be built, and for a length that a body keeps.
    fn along(
        &self,
        points: &[(usize, Vector3<f64>)],
        lengths: &[(usize, f64)],
    ) -> Option<Expansion>;
}
