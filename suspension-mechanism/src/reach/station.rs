//! A place on the curve of a freed drive.

use crate::mechanism::State;

/// A place on the curve of a freed drive.
#[derive(Clone, Debug, PartialEq)]
pub struct Station {
    /// The number of the free drive, from 0.
    pub freed: usize,
    /// Whether the drive turns here.
    pub turns: bool,
    /// How far the free points move, the root of the sum of their squares, for a unit of the
    /// drive: in the unit for a radian, or for one of its own. Infinite where the drive turns, but at the end of an angle.
    pub speed: f64,
    /// The mechanism at rest.
    pub state: State,
}

impl Station {
    /// The drive's value, in rad or the unit.
    pub fn value(&self) -> f64 {
        self.state.drives[self.freed]
    }
}
