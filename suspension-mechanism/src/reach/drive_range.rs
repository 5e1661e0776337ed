//! The range of a drive, and the parts of it in which the transmission is poor.

use suspension_core::listing::DriveKind;

use crate::mechanism::State;
use crate::reach::limit::RangeEnd;

/// The multiple of its smallest value in the range above which the points' speed per unit of the drive indicates a
/// poor transmission.
pub const POOR: f64 = 5.0;

/// The range of one drive.
#[derive(Clone, Debug, PartialEq)]
pub struct DriveRange {
    /// Its name.
    pub name: String,
    /// Its index among the drives.
    pub index: usize,
    /// The kind of its value.
    pub kind: DriveKind,
    /// Its value at the first instant.
    pub start: f64,
    /// The lower and the upper end of the values to which it can lead the mechanism from there.
    pub ends: [RangeEnd; 2],
    /// Places in the range, from the lower end to the upper.
    pub usable: Vec<Station>,
    /// All places of the curve, including those to which the drive cannot lead.
    pub curve: Vec<Station>,
    /// The number of turning points of the drive on the curve.
    pub turns: usize,
    /// The gap with which the curve closes; `None` if it is open.
    pub gap: Option<f64>,
}

impl DriveRange {
    /// The intervals of the drive's value in which the transmission is poor: the points move more than [`POOR`] times
    /// as far per unit of the drive as at the place in the range where they move least.
    pub fn poor(&self) -> Vec<[f64; 2]> {
        let speeds = self.usable.iter().map(|station| station.speed);
        let least = speeds.fold(f64::INFINITY, f64::min);
        // A drive of a point that only measures read moves no point of the mechanism; a drive at the end of its angle
        // has no range.
        if least == 0.0 || least.is_infinite() {
            return Vec::new();
        }
        // The inverse passes zero where the drive turns.
        let margin = |station: &Station| 1.0 / station.speed - 1.0 / (POOR * least);
        let mut intervals: Vec<[f64; 2]> = Vec::new();
        for pair in self.usable.windows(2) {
            let [from, to] = [&pair[0], &pair[1]];
            let [before, after] = [margin(from), margin(to)];
            if before >= 0.0 && after >= 0.0 {
                continue;
            }
            let crossing = from.value() + (to.value() - from.value()) * before / (before - after);
            let low = if before < 0.0 { from.value() } else { crossing };
            let high = if after < 0.0 { to.value() } else { crossing };
            match intervals.last_mut() {
                Some(last) if last[1] == low => last[1] = high,
                _ => intervals.push([low, high]),
            }
        }
        intervals
    }
}

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
