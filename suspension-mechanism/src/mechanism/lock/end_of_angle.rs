//! A driven angle at the end of its range.

use std::f64::consts::PI;

use suspension_core::SolveError;
use suspension_core::listing::{DriveKind, Part};

use crate::file::{Dimension, Unit};
use crate::mechanism::parts::names::Names;
use crate::number::rounded;

/// The distance from the end, in radians, within which the equations of an angle from an axis do not show that the
/// drive moves, because its cosine enters them.
const NEAR: f64 = 1e-6;

/// A driven angle at the end of its range.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct EndOfAngle {
    drive: usize,
    /// The end in radians.
    end: f64,
}

impl EndOfAngle {
    /// The angle at its end where a motion has stopped, with the drives at `drives` in the file's coordinates.
    pub(crate) fn find(
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

    pub(crate) fn in_words(&self, names: &Names, unit: Unit) -> String {
        const DIGITS: usize = 6;
        let drive = &names.drives[self.drive];
        let dimension = Dimension::from(drive.kind);
        let end = rounded(self.end * unit.file_factor(dimension), DIGITS);
        let (name, symbol) = (&drive.name, dimension.symbol(unit));
        let remedy = match drive.kind {
            DriveKind::Angle => {
                "; to drive it beyond, write it in the listing as an angle about a line: `angle(p -> q, r -> s about t -> u)`"
            }
            _ => "",
        };
        format!(
            "the angle `{name}` ends at {end} {symbol}, and beyond it the same positions repeat{remedy}"
        )
    }
}
