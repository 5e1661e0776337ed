//! A driven angle at the end of its range.

use std::f64::consts::PI;

use suspension_core::SolveError;
use suspension_core::listing::{DriveKind, Part};

use crate::file::Dimension;
use crate::mechanism::names::Names;
use crate::number::rounded;
use suspension_motion_file::Unit;

/// How near the end, in radians, the equations of an angle from an axis do not notice that the drive moves: its cosine enters.
const NEAR: f64 = 1e-6;

/// A driven angle at the end of its range.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct EndOfAngle {
    drive: usize,
    /// In radians.
    end: f64,
}

impl EndOfAngle {
    /// Where a motion has stopped with the drives, in the file's coordinates, at `drives`.
    pub(super) fn of(
        names: &Names,
        cause: Option<&SolveError<f64>>,
        drives: &[f64],
    ) -> Option<Self> {
        if let Some(&SolveError::OutOfRange { part, end, .. }) = cause {
            let Part::Drive(drive) = part else {
                return None;
            };
            return Some(Self { drive, end });
        }
        let each = names.drives.iter().zip(drives).enumerate();
        let mut angles = each.filter(|(_, (drive, _))| drive.kind == DriveKind::Angle);
        angles.find_map(|(drive, (_, angle))| {
            let mut ends = [0.0, PI].into_iter();
            let end = ends.find(|end| (angle - end).abs() < NEAR)?;
            Some(Self { drive, end })
        })
    }

    pub(super) fn in_words(&self, names: &Names, unit: Unit) -> String {
        const DIGITS: usize = 6;
        let drive = &names.drives[self.drive];
        let dimension = Dimension::from(drive.kind);
        let end = rounded(self.end * dimension.in_file(unit), DIGITS);
        let (name, symbol) = (&drive.name, dimension.symbol(unit));
        let remedy = match drive.kind {
            DriveKind::Angle => {
                "; to drive it there and past it, write it in the listing as one about a line: `angle(p -> q, r -> s about t -> u)`"
            }
            _ => "",
        };
        format!(
            "the angle `{name}` ends at {end} {symbol}, beyond it the same positions come again{remedy}"
        )
    }
}
