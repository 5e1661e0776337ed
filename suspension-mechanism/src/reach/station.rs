//! A place on the curve of a freed drive.

use crate::mechanism::State;

/// A place on the curve of a freed drive.
#[derive(Clone, Debug, PartialEq)]
pub struct Station {
    /// The number of the free drive, from 0.
    pub freed: usize,
    /// Whether the drive turns here.
    pub turns: bool,
    /// The distance that the free points move (the root of the sum of their squares) per unit of the drive: in the
    /// unit per radian, or per unit. Infinite where the drive turns, except at the end of an angle.
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
