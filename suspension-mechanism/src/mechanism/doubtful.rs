//! Values of a drive that seem to be in another unit, or counted from elsewhere, than the file's.

use nalgebra::Vector3;

use crate::mechanism::grid::From;
use crate::number::rounded;
use suspension_motion_file::Length;

/// A drive that is a coordinate, and the mechanism that it moves; lengths in the unit of the file.
#[derive(Clone, Copy, Debug)]
pub struct Coordinate<'a> {
    /// Its name.
    pub name: &'a str,
    /// Its value at the design position.
    pub design: f64,
    /// How far the points of the mechanism are apart: no drive moves them as far.
    pub size: f64,
    /// The unit.
    pub unit: Length,
}

/// How near the design position a value is at it, as a part of the value.
const AT_DESIGN: f64 = 0.01;

/// What is small beside the size, or beside the value at the design position.
const SMALL: f64 = 0.1;

/// A motion that is smaller, as a part of the size, moves nothing that could be read.
const NO_MOTION: f64 = 2e-4;

/// Digits of a value in words.
const DIGITS: usize = 4;

impl Coordinate<'_> {
    /// How far points are apart: the diagonal of the box about them.
    pub fn extent(points: impl IntoIterator<Item = Vector3<f64>>) -> f64 {
        let corners = points.into_iter().map(|at| (at, at));
        let corners = corners.reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)));
        corners.map_or(0.0, |(low, high)| (high - low).norm())
    }

    /// What is doubtful in the values between two that it is to take, counted `from`, with what to write instead; `way` says
    /// how to write the other way of counting.
    pub fn doubt(&self, ends: [f64; 2], from: From, way: &str) -> Option<String> {
        let [least, greatest] = ends;
        let spans = |value: f64| {
            let margin = AT_DESIGN * value.abs();
            (least - margin..=greatest + margin).contains(&value)
        };
        let starts_small =
            least.abs().min(greatest.abs()) <= SMALL * self.design.abs() || spans(0.0);
        let is_elsewhere = self.design.abs() > SMALL * self.size;
        if let Some(unit) = self.other_unit(ends, from) {
            let (name, file) = (self.name, self.unit.in_words());
            return Some(format!("is `{name}` in {unit}? The file is in {file}"));
        }
        let at = format!(
            "`{}` is {} {} at the design position",
            self.name,
            rounded(self.design, DIGITS),
            self.unit.symbol()
        );
        match from {
            From::Zero if is_elsewhere && starts_small && !spans(self.design) => Some(format!(
                "`{}` takes the drive's own value, not a change from the design position: {at}{way}",
                self.name
            )),
            From::Start if is_elsewhere && spans(self.design) && !spans(0.0) => Some(format!(
                "`{}` takes a change from the design position, not the drive's own value: {at}{way}",
                self.name
            )),
            _ => None,
        }
    }

    /// The units in which the values would be those of a motion, where in that of the file they are not.
    fn other_unit(&self, ends: [f64; 2], from: From) -> Option<String> {
        let zero = match from {
            From::Zero => self.design,
            From::Start => 0.0,
        };
        let farthest = |factor: f64| {
            let off = ends.map(|end| (end * factor - zero).abs());
            off[0].max(off[1])
        };
        let far = farthest(1.0);
        let motion = (ends[1] - ends[0]).abs();
        let moves_nothing = motion > 0.0 && motion < NO_MOTION * self.size && far < self.size;
        let is_at = |factor: f64| {
            let off = (ends[0] * factor - self.design).abs();
            from == From::Zero && off < AT_DESIGN * self.design.abs()
        };
        let fits = |unit: &Length| {
            let factor = self.unit.metre() / unit.metre();
            let moved = motion * factor;
            let within = farthest(factor) < self.size / 2.0;
            (far > self.size && within)
                || (is_at(factor) && !is_at(1.0))
                || (moves_nothing && (SMALL * SMALL..1.0).contains(&(moved / self.size)))
        };
        let others = Length::ALL.into_iter().filter(|unit| *unit != self.unit);
        let units: Vec<&str> = others.filter(fits).map(Length::in_words).collect();
        (!units.is_empty()).then(|| units.join(" or "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_in_another_unit_or_from_elsewhere_are_doubted() {
        let metres = Coordinate {
            name: "bump",
            design: 0.3,
            size: 0.8,
            unit: Length::Metre,
        };
        let millimetres = Coordinate {
            design: 300.0,
            size: 800.0,
            unit: Length::Millimetre,
            ..metres
        };
        for (drive, ends, from, expected) in [
            (
                metres,
                [300.0, 350.0],
                From::Zero,
                "is `bump` in mm? The file is in m",
            ),
            (metres, [0.3, 50.3], From::Zero, "is `bump` in mm"),
            (metres, [-80.0, 80.0], From::Start, "is `bump` in mm"),
            (
                metres,
                [-3.0, 3.0],
                From::Start,
                "is `bump` in mm or inches?",
            ),
            (
                metres,
                [0.0, 0.05],
                From::Zero,
                "takes the drive's own value",
            ),
            (
                metres,
                [-0.05, 0.05],
                From::Zero,
                "`bump` is 0.3 m at the design position",
            ),
            (
                metres,
                [0.22, 0.38],
                From::Start,
                "takes a change from the design position",
            ),
            (
                metres,
                [0.3, 0.3],
                From::Start,
                "takes a change from the design position",
            ),
            (
                millimetres,
                [0.3, 0.35],
                From::Zero,
                "is `bump` in m? The file is in mm",
            ),
            (millimetres, [300.0, 300.05], From::Zero, "is `bump` in m?"),
            (millimetres, [-0.05, 0.05], From::Start, "is `bump` in m?"),
            (metres, [0.25, 0.35], From::Zero, ""),
            (metres, [0.3, 0.3], From::Zero, ""),
            (metres, [-0.08, 0.08], From::Start, ""),
            (metres, [0.0, 0.0], From::Start, ""),
            (metres, [1e-9, 2e-9], From::Start, ""),
            (millimetres, [-80.0, 80.0], From::Start, ""),
            (millimetres, [220.0, 380.0], From::Zero, ""),
        ] {
            let said = drive.doubt(ends, from, "").unwrap_or_default();
            assert!(said.contains(expected), "{ends:?}: {said}");
            assert_eq!(said.is_empty(), expected.is_empty(), "{ends:?}: {said}");
        }
    }
}
