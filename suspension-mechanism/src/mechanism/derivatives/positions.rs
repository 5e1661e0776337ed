//! The position of a mechanism, in numbers that have derivatives.

use nalgebra::Vector3;
use suspension_core::Signal;

use crate::mechanism::state::State;

/// The points of a mechanism at one place of its motion, its measures and how drives move it, in numbers that carry
/// derivatives: all that is needed to compute quantities which positions determine. Local coordinates, in the file's
/// axes.
pub trait Positions<N> {
    /// A point.
    fn point(&self, point: usize) -> Vector3<N>;

    /// A measure, in the file's coordinates.
    fn measure(&self, measure: usize) -> N;

    /// The velocity of a point when a drive moves it, with the others held; `None` if it is not known: see
    /// [`State::velocities`].
    fn velocity(&self, point: usize, drive: usize) -> Option<Vector3<N>>;
}

/// The derivatives are those along the rates of the state.
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
