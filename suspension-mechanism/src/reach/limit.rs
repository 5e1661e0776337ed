//! The limits of a drive.

use crate::mechanism::{Mechanism, Suspension, Unit};
use crate::number::rounded;

/// An end of a drive's range.
#[derive(Clone, Debug, PartialEq)]
pub struct RangeEnd {
    /// The drive's value, in rad or the unit.
    pub value: f64,
    /// The limit at this end.
    pub limit: Limit,
}

/// The reason why a drive reaches no further.
#[derive(Clone, Debug, PartialEq)]
pub enum Limit {
    /// The drive turns: led by it, the mechanism locks.
    Locks {
        /// A description of the link that is too long or too short to go on, or of the hinge that reaches no further,
        /// if one is known.
        fault: Option<String>,
    },
    /// The angle itself is 0 or pi.
    EndOfAngle,
    /// The driven length is zero, with a description.
    ZeroLength(String),
    /// Another curve crosses within this distance of the value, in the unit of length.
    Bifurcation(f64),
    /// The search was cut short: the steps were used up, or the user interrupted.
    Cut,
    /// No further place was found, with the reason.
    Lost(String),
}

impl Limit {
    /// A description of the limit.
    pub fn in_words(&self, unit: Unit) -> String {
        match self {
            Self::Locks { fault } => {
                let fault = fault.as_ref().map(|fault| format!(": {fault}"));
                let lock = "turning point of the drive, the mechanism locks";
                format!("{lock}{}", fault.unwrap_or_default())
            }
            Self::EndOfAngle => {
                "the end of the angle, and beyond it the same positions repeat".to_owned()
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

/// A description of the link or the hinge that prevents a drive from going beyond a value, in the file's coordinates.
pub(super) fn fault_beyond<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    drive: usize,
    value: f64,
) -> Option<String> {
    /// The distance beyond, as a fraction of the way there.
    const BEYOND: f64 = 0.01;
    let start = mechanism.first_drives()[drive];
    let end = value - mechanism.drive_offsets[drive];
    let lock = mechanism.lock_before(drive, end + BEYOND * (end - start))?;
    lock.fault()
}
