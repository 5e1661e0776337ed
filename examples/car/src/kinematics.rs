//! The motion of a wheel relative to the chassis, for all ways to compute it.

mod baked;
mod constant;
mod grid;
mod hub;
mod solved;

use std::fmt;

use suspension_core::Signal;
use suspension_core::error::Cause;

pub use baked::{Baked, COORDINATES, Table};
pub use constant::Constant;
pub use grid::Grid;
pub use hub::{Hub, Marks, PerTravel};
pub use solved::{Solved, bounded, exact};

/// The drives of a left corner's wheel, as changes from the design position in m: the height of the wheel centre, and the
/// position of the rack to the left. A corner without a rack ignores the second.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drives {
    /// Bump travel, upwards.
    pub travel: f64,
    /// Rack travel, to the left.
    pub rack: f64,
}

/// A left corner's kinematics.
pub trait Kinematics: Send {
    /// The hub a time `dt` after the last call.
    ///
    /// # Errors
    ///
    /// [`Refused`]; the next call may succeed.
    fn step(&mut self, dt: f64, drives: &Signal<Drives>) -> Result<Hub, Refused>;

    /// Moves from the design position to the position at which another detail has left a wheel, in as many steps as
    /// necessary: before the first tick in a new detail. Kinematics that look up or multiply need no such move.
    ///
    /// # Errors
    ///
    /// [`Refused`].
    fn enter(&mut self, _drives: &Drives) -> Result<(), Refused> {
        Ok(())
    }
}

/// No motion of a wheel is known for these drives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refused {
    /// The drives that the wheel was to follow.
    pub drives: Drives,
    /// The reason.
    pub why: Why,
}

/// The reason for which a wheel's motion is not known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Why {
    /// The solver refused.
    Solver(Cause),
    /// The table ends before.
    OutsideTable,
}

impl Refused {
    fn by_solver(drives: Drives, cause: Cause) -> Self {
        let why = Why::Solver(cause);
        Self { drives, why }
    }
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Drives { travel, rack } = self.drives;
        write!(f, "travel {travel:.4} m, rack {rack:.4} m: ")?;
        match self.why {
            Why::Solver(cause) => write!(f, "{}; {}", cause.what(), cause.remedy()),
            Why::OutsideTable => f.write_str("outside the baked range; bake a larger one"),
        }
    }
}

impl std::error::Error for Refused {}
