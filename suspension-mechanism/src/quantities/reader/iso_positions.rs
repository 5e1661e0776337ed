//! The positions of a state's points, in the axes of ISO 8855.

use nalgebra::Vector3;

use crate::mechanism::{Positions, State};
use crate::quantities::number::Number;

/// A state, and what its positions determine, in numbers of this type.
#[derive(Clone, Copy)]
pub(crate) struct IsoPositions<'a, N> {
    pub(crate) state: &'a State,
    pub(crate) numbers: &'a dyn Positions<N>,
}

impl<N: Number> IsoPositions<'_, N> {
    /// A point in local coordinates, in the axes of ISO 8855.
    pub(crate) fn at(&self, point: usize) -> Vector3<N> {
        self.state.axes.turned(self.numbers.point(point))
    }

    /// Its velocity when a drive moves it, in these axes, if it is known.
    pub(crate) fn velocity(&self, point: usize, drive: usize) -> Option<Vector3<N>> {
        let velocity = self.numbers.velocity(point, drive)?;
        Some(self.state.axes.turned(velocity))
    }

    /// A fixed place in these axes.
    pub(crate) fn still(&self, place: Vector3<f64>) -> Vector3<N> {
        self.state.axes.turned(place).map(N::still)
    }

    /// The origin of local coordinates, in these axes.
    pub(crate) fn origin(&self) -> Vector3<N> {
        self.still(self.state.origin)
    }
}
