//! A change of the design.

use crate::kinematics::Changes;

/// What is changed.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// Its name: `tie_ball.z`, `length tie_rod`, or a move's.
    pub name: String,
    /// What it is, of one unit of length.
    pub per_unit: Changes,
}
