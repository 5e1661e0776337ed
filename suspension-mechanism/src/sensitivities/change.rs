//! A change of the design.

use crate::kinematics::Changes;

/// A change of the design.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// Its name: `tie_ball.z`, `length tie_rod`, or the name of a move.
    pub name: String,
    /// The change for one unit of length.
    pub per_unit: Changes,
}
