//! The limits of a drive.

use crate::mechanism::{Mechanism, Suspension, Unit};
use crate::number::rounded;

/// An end of a drive's range.
#[derive(Clone, Debug, PartialEq)]
pub struct RangeEnd {
    /// The drive's value, in rad or the unit.
    pub value: f64,
    /// What the end is.
    pub limit: Limit,
}

/// What limits a drive.
#[derive(Clone, Debug, PartialEq)]
pub enum Limit {
    /// The drive turns: led by it, the mechanism locks.
    Locks {
        /// The link that is too long or too short to go on, or the hinge that reaches no further, in words, where one is known.
        fault: Option<String>,
    },
    /// The angle itself is 0 or pi.
    EndOfAngle,
    /// The driven length is zero, in words.
    ZeroLength(String),
    /// Another curve crosses within so much of the value, in the unit of length.
    Bifurcation(f64),
    /// The search was cut short: all steps were made, or the user interrupted.
    Cut,
    /// No further place was found, and why.
    Lost(String),
}

impl Limit {
    /// What it is, in words.
    pub fn in_words(&self, unit: Unit) -> String {
        match self {
            Self::Locks { fault } => {
                let fault = fault.as_ref().map(|fault| format!(": {fault}"));
                let lock = "turning point of the drive, the mechanism locks";
                format!("{lock}{}", fault.unwrap_or_default())
            }
            Self::EndOfAngle => {
                "the end of the angle, beyond it the same positions come again".to_owned()
            }
            Self::ZeroLength(fault) => fault.clone(),
            Self::Bifurcation(accuracy) => format!(
                "bifurcation within {} {} along the curve, the mechanism can go either way",
                rounded(*accuracy, 2),
                unit.symbol()
            ),
            Self::Cut => "the search was cut short here".to_owned(),
            Self::Lost(cause) => format!("no further place was found ({cause})"),
        }
    }
}

/// What is wrong with the link or the hinge that keeps a drive from going beyond a value, in the file's coordinates.
pub(super) fn fault_beyond<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    drive: usize,
    value: f64,
) -> Option<String> {
    /// How far beyond, as a part of the way there.
    const BEYOND: f64 = 0.01;
    let start = mechanism.first_drives()[drive];
    let end = value - mechanism.drive_offsets[drive];
    let lock = mechanism.lock_before(drive, end + BEYOND * (end - start))?;
    lock.fault()
}
