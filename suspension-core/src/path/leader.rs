//! How to follow a motion that a quantity leads.

use crate::arithmetic::scalar::Real;
use crate::solve::newton::Newton;
use crate::step::substeps::MAX_STEPS;
use crate::step::tracker::{CORRECTION_OF_MOVE, CORRECTION_OF_SIZE};

/// Settings for following a motion that a quantity leads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leader<T> {
    /// The settings with which each step is solved.
    pub newton: Newton<T>,
    /// The number of steps that one advance may try, including refused ones.
    pub max_steps: usize,
    /// See [`Tracker::correction_of_move`](crate::Tracker::correction_of_move).
    pub correction_of_move: T,
    /// See [`Tracker::correction_of_size`](crate::Tracker::correction_of_size).
    pub correction_of_size: T,
}

impl<T: Real> Default for Leader<T> {
    fn default() -> Self {
        Self {
            newton: Newton::near_by(),
            max_steps: MAX_STEPS,
            correction_of_move: T::constant(CORRECTION_OF_MOVE),
            correction_of_size: T::constant(CORRECTION_OF_SIZE),
        }
    }
}
