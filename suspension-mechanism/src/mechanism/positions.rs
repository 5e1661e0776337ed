//! The position of a mechanism, in numbers that have derivatives.

use nalgebra::Vector3;
use suspension_core::Signal;

use crate::mechanism::state::State;

/// The points of a mechanism at one place of its motion, what its linkage measures and how drives move it, in numbers
/// that have derivatives: all that quantities which positions determine are computed from. In local coordinates, in the
/// file's axes.
pub trait Positions<N> {
    /// A point.
    fn point(&self, point: usize) -> Vector3<N>;

    /// What the linkage measures, in the file's coordinates.
    fn measure(&self, measure: usize) -> N;

    /// The velocity of a point as a drive moves it, the others held; `None` where it is not known: see
    /// [`State::velocities`].
    fn velocity(&self, point: usize, drive: usize) -> Option<Vector3<N>>;
}

/// With the derivatives along the rates of the state.
impl Positions<Signal<f64>> for State {
    fn point(&self, point: usize) -> Vector3<Signal<f64>> {
        self.points.map(|points| points[point]).components()
    }

    fn measure(&self, measure: usize) -> Signal<f64> {
        self.measures.map(|measures| measures[measure])
    }

    fn velocity(&self, point: usize, drive: usize) -> Option<Vector3<Signal<f64>>> {
        let velocities = self.moved_by(drive)?;
        Some(velocities.map(|points| points[point]).components())
    }
}
