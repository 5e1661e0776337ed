//! Values of a drive that seem to be in another unit than the file's, or counted from elsewhere.

use std::f64::consts::TAU;

use suspension_core::listing::DriveKind;

use crate::file::{Dimension, Length, Unit};
use crate::mechanism::grid::CountedFrom;
use crate::mechanism::parts::names::Drive;
use crate::number::rounded;

/// A drive at the design position, and the mechanism that it moves; lengths in the unit of the file, angles in radians.
#[derive(Clone, Copy, Debug)]
pub struct DriveAtDesign<'a> {
    /// The drive.
    pub drive: &'a Drive,
    /// Its value at the design position.
    pub design: f64,
    /// The diagonal of the box around the points of the mechanism: no drive moves them as far.
    pub size: f64,
    /// The units.
    pub unit: Unit,
    /// How long it takes to move through its values, s; one where no time is stated.
    pub seconds: f64,
}

/// The distance within which a value counts as that at the design position, as a fraction of the value.
const AT_DESIGN: f64 = 0.01;

/// The fraction of the size, or of the value at the design position, below which something is small.
const SMALL: f64 = 0.1;

/// A motion smaller than this, as a fraction of the size, is 0.3 mm of a car: nobody moves a drive by so little, but in a small
/// part of a second.
const NO_MOTION: f64 = 4e-4;

/// The number of digits of a value in messages.
const DIGITS: usize = 4;

impl DriveAtDesign<'_> {
    /// Describes what is doubtful in the values between two that a drive is to take, counted `from`, with what to
    /// write instead; `way` says how to write the other way of counting. An angle about a line may well begin at zero.
    pub fn doubt(&self, ends: [f64; 2], from: CountedFrom, way: &str) -> Option<String> {
        match self.drive.kind {
            DriveKind::Coordinate => {
                let other_unit = self.other_unit(ends, from).map(|unit| {
                    let (name, file) = (&self.drive.name, self.unit.length.in_words());
                    format!("is `{name}` in {unit}? The file is in {file}")
                });
                let other_unit =
                    other_unit.or_else(|| self.counted_otherwise(ends, from, self.size, way));
                other_unit.or_else(|| self.opposite(ends, from, way))
            }
            DriveKind::Angle => self.counted_otherwise(ends, from, TAU, way),
            DriveKind::Turn => None,
        }
    }

    /// The doubt that values seem to be counted otherwise than `from`, given a size by which no drive moves.
    fn counted_otherwise(
        &self,
        [least, greatest]: [f64; 2],
        from: CountedFrom,
        size: f64,
        way: &str,
    ) -> Option<String> {
        let spans = |value: f64| {
            let margin = AT_DESIGN * value.abs();
            (least - margin..=greatest + margin).contains(&value)
        };
        let starts_small =
            least.abs().min(greatest.abs()) <= SMALL * self.design.abs() || spans(0.0);
        let is_elsewhere = self.design.abs() > SMALL * size;
        let [takes, not] = match from {
            CountedFrom::Zero if is_elsewhere && starts_small && !spans(self.design) => {
                ["the drive's own value", "a change from the design position"]
            }
            CountedFrom::Start if is_elsewhere && spans(self.design) && !spans(0.0) => {
                ["a change from the design position", "the drive's own value"]
            }
            _ => return None,
        };
        let dimension = Dimension::from(self.drive.kind);
        let (name, symbol) = (&self.drive.name, dimension.symbol(self.unit));
        let design = rounded(self.design * self.unit.file_factor(dimension), DIGITS);
        Some(format!(
            "`{name}` takes {takes}, not {not}: `{name}` is {design} {symbol} at the design position{way}"
        ))
    }

    /// The doubt that values seem to have the wrong sign, as those of the rack's other end in its mirror image.
    fn opposite(
        &self,
        [least, greatest]: [f64; 2],
        from: CountedFrom,
        way: &str,
    ) -> Option<String> {
        let margin = AT_DESIGN * self.design.abs();
        let spans = |value: f64| (least - margin..=greatest + margin).contains(&value);
        let is_elsewhere = self.design.abs() > SMALL * self.size;
        let is_opposite = from == CountedFrom::Zero && spans(-self.design) && !spans(self.design);
        (is_elsewhere && is_opposite).then(|| {
            let (name, symbol) = (&self.drive.name, self.unit.length.symbol());
            let design = rounded(self.design, DIGITS);
            format!("is the sign of `{name}` right? `{name}` is {design} {symbol} at the design position{way}")
        })
    }

    /// The units in which the values would be those of a motion, if they are not in the unit of the file.
    fn other_unit(&self, ends: [f64; 2], from: CountedFrom) -> Option<String> {
        let zero = match from {
            CountedFrom::Zero => self.design,
            CountedFrom::Start => 0.0,
        };
        let farthest = |factor: f64| {
            let off = ends.map(|end| (end * factor - zero).abs());
            off[0].max(off[1])
        };
        let far = farthest(1.0);
        let motion = (ends[1] - ends[0]).abs();
        let least = NO_MOTION * self.size * self.seconds.min(1.0);
        let moves_nothing = motion > 0.0 && motion < least && far < self.size;
        let is_at = |factor: f64| {
            let off = (ends[0] * factor - self.design).abs();
            from == CountedFrom::Zero && off < AT_DESIGN * self.design.abs()
        };
        let fits = |unit: &Length| {
            let factor = self.unit.length.metre() / unit.metre();
            let moved = motion * factor;
            let within = farthest(factor) < self.size / 2.0;
            (far > self.size && within)
                || (is_at(factor) && !is_at(1.0))
                || (moves_nothing && (SMALL * SMALL..1.0).contains(&(moved / self.size)))
        };
        let others = Length::ALL
            .into_iter()
            .filter(|unit| *unit != self.unit.length);
        let units: Vec<&str> = others.filter(fits).map(Length::in_words).collect();
        (!units.is_empty()).then(|| units.join(" or "))
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use suspension_motion_file::Angle;

    use super::*;
    use CountedFrom::{Start, Zero};

    #[test]
    fn drive_values_in_another_unit_or_from_another_zero_are_doubted() {
        let named = |name: &str, kind| Drive {
            name: name.to_owned(),
            kind,
        };
        let unit = |length| Unit {
            length,
            angle: Angle::Degree,
        };
        let [bump, arm, crank] = [
            named("bump", DriveKind::Coordinate),
            named("arm", DriveKind::Angle),
            named("crank", DriveKind::Turn),
        ];
        let metres = DriveAtDesign {
            drive: &bump,
            design: 0.3,
            size: 0.8,
            unit: unit(Length::Metre),
            seconds: 1.0,
        };
        let millimetres = DriveAtDesign {
            design: 300.0,
            size: 800.0,
            unit: unit(Length::Millimetre),
            ..metres
        };
        let brief = DriveAtDesign {
            seconds: 0.008,
            ..millimetres
        };
        let arm = DriveAtDesign {
            drive: &arm,
            design: FRAC_PI_2,
            ..metres
        };
        let crank = DriveAtDesign {
            drive: &crank,
            ..arm
        };
        for (drive, ends, from, expected) in [
            (
                metres,
                [300.0, 350.0],
                Zero,
                "is `bump` in mm? The file is in m",
            ),
            (metres, [0.3, 50.3], Zero, "is `bump` in mm"),
            (metres, [-80.0, 80.0], Start, "is `bump` in mm"),
            (metres, [-3.0, 3.0], Start, "is `bump` in mm or inches?"),
            (metres, [0.0, 0.05], Zero, "takes the drive's own value"),
            (
                metres,
                [-0.05, 0.05],
                Zero,
                "`bump` is 0.3 m at the design position",
            ),
            (
                metres,
                [0.22, 0.38],
                Start,
                "takes a change from the design position",
            ),
            (
                metres,
                [0.3, 0.3],
                Start,
                "takes a change from the design position",
            ),
            (
                millimetres,
                [0.3, 0.35],
                Zero,
                "is `bump` in m? The file is in mm",
            ),
            (millimetres, [300.0, 300.05], Zero, "is `bump` in m?"),
            (brief, [300.0, 300.05], Zero, ""),
            (brief, [0.3, 0.30005], Zero, "is `bump` in m?"),
            (millimetres, [-0.05, 0.05], Start, "is `bump` in m?"),
            (millimetres, [-0.08, 0.08], Start, "is `bump` in m?"),
            (
                arm,
                [0.006, 0.006],
                Zero,
                "`arm` takes the drive's own value, not a change from the design position: `arm` is 90 deg at the design position",
            ),
            (arm, [-0.2, 0.2], Zero, "takes the drive's own value"),
            (
                arm,
                [FRAC_PI_2, FRAC_PI_2],
                Start,
                "takes a change from the design position",
            ),
            (arm, [-0.2, 0.2], Start, ""),
            (arm, [0.7, 1.2], Zero, ""),
            (arm, [0.0, 3.0], Zero, ""),
            (crank, [0.0, 0.5], Zero, ""),
            (metres, [0.25, 0.35], Zero, ""),
            (metres, [0.3, 0.3], Zero, ""),
            (metres, [-0.08, 0.08], Start, ""),
            (metres, [0.0, 0.0], Start, ""),
            (metres, [1e-9, 2e-9], Start, ""),
            (millimetres, [-80.0, 80.0], Start, ""),
            (millimetres, [220.0, 380.0], Zero, ""),
        ] {
            let doubt = drive.doubt(ends, from, "").unwrap_or_default();
            assert!(doubt.contains(expected), "{ends:?}: {doubt}");
            assert_eq!(doubt.is_empty(), expected.is_empty(), "{ends:?}: {doubt}");
        }
    }
}
