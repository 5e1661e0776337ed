//! The derivatives of a mechanism with respect to its design.

use nalgebra::Vector3;

/// Points and measures with their derivatives with respect to the drives, or the derivatives of all these along a change of the
/// design.
#[derive(Clone, Debug, Default)]
pub struct Expansion {
    /// The points, or their first or second derivatives with respect to drives, by row behind each other.
    pub points: Vec<Vector3<f64>>,
    /// The measures, then their derivatives with respect to each drive.
    pub measures: Vec<f64>,
}

/// A mechanism where it starts, and how it changes with its design.
pub trait Changing {
    /// Its points and measures, with their derivatives with respect to the drives.
    fn start(&self) -> &Expansion;

    /// The derivatives of these along a change: of points by number, each with how far it is moved, and of lengths, each with how
    /// much longer it is; `None` where no such suspensions can be built, and of a length that a body keeps.
    fn along(
        &self,
        points: &[(usize, Vector3<f64>)],
        lengths: &[(usize, f64)],
    ) -> Option<Expansion>;
}
