//! The units of a file.

use serde::Deserialize;
use suspension_core::listing::DriveKind;

/// A unit of length.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
pub enum Length {
    /// Metres.
    #[serde(rename = "m")]
    Metre,
    /// Millimetres.
    #[serde(rename = "mm")]
    Millimetre,
    /// Inches.
    #[serde(rename = "in")]
    Inch,
}

impl Length {
    /// All units.
    pub const ALL: [Self; 3] = [Self::Metre, Self::Millimetre, Self::Inch];

    /// Returns the unit in which a suspension would most probably have the size `size`.
    pub fn guess_from_size(size: f64) -> Self {
        let off = |unit: &Self| (size / unit.metre()).ln().abs();
        let nearest = Self::ALL
            .into_iter()
            .min_by(|a, b| off(a).total_cmp(&off(b)));
        nearest.unwrap_or(Self::Metre)
    }

    /// The symbol of the unit.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Metre => "m",
            Self::Millimetre => "mm",
            Self::Inch => "in",
        }
    }

    /// The name of the unit in a sentence.
    pub fn in_words(self) -> &'static str {
        match self {
            Self::Inch => "inches",
            metric => metric.symbol(),
        }
    }

    /// The number of this unit in a metre.
    pub fn metre(self) -> f64 {
        match self {
            Self::Metre => 1.0,
            Self::Millimetre => 1000.0,
            Self::Inch => 1.0 / 0.0254,
        }
    }

    /// The decimals of a length in a table: a hundredth of a millimetre, or finer.
    pub fn decimals(self) -> usize {
        match self {
            Self::Metre => 5,
            Self::Millimetre => 2,
            Self::Inch => 4,
        }
    }
}

/// A unit of angles.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
pub enum Angle {
    /// Radians.
    #[default]
    #[serde(rename = "rad")]
    Radian,
    /// Degrees.
    #[serde(rename = "deg")]
    Degree,
}

impl Angle {
    /// The symbol of the unit.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Radian => "rad",
            Self::Degree => "deg",
        }
    }

    /// The number of this unit in a radian.
    pub fn radian(self) -> f64 {
        match self {
            Self::Radian => 1.0,
            Self::Degree => 1_f64.to_degrees(),
        }
    }

    /// Returns an angle in this unit, computed from radians, as a file states it: degrees are rounded to 15 digits if they
    /// then differ by rounding only, so that -10 in a file is shown as -10, not as -10.000000000000004.
    pub fn as_stated(self, angle: f64) -> f64 {
        const ROUNDING: f64 = 4.0 * f64::EPSILON;
        if self == Self::Radian {
            return angle;
        }
        let few = format!("{angle:.14e}").parse().unwrap_or(angle);
        let is_same = (few - angle).abs() <= ROUNDING * angle.abs();
        if is_same { few } else { angle }
    }

    /// Returns, in words, the bounds of a drive if `value`, in radians if it is an angle, exceeds them.
    pub fn bounds_exceeded(self, kind: DriveKind, value: f64) -> Option<String> {
        let half_turn = match self {
            Self::Radian => "pi",
            Self::Degree => "180 deg",
        };
        kind.end_exceeded(value).map(|_| match kind {
            DriveKind::Turn => {
                "an angle about an axis must be less than a whole turn to either side".to_owned()
            }
            _ => format!("the angle of a link from an axis must lie between 0 and {half_turn}"),
        })
    }
}

/// The units of a file. The program computes with the file's unit of lengths and with radians.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unit {
    /// The unit of lengths.
    pub length: Length,
    /// The unit of angles.
    pub angle: Angle,
}

impl Unit {
    /// Metres and radians.
    pub const METRE: Self = Self {
        length: Length::Metre,
        angle: Angle::Radian,
    };

    /// All units that a file may have.
    pub fn all() -> impl Iterator<Item = Self> {
        let angles = [Angle::Degree, Angle::Radian];
        let all = Length::ALL.into_iter();
        all.flat_map(move |length| angles.map(|angle| Self { length, angle }))
    }

    /// The symbol of the unit of lengths.
    pub fn symbol(self) -> &'static str {
        self.length.symbol()
    }

    /// The number of units of length in a metre.
    pub fn metre(self) -> f64 {
        self.length.metre()
    }
}

#[cfg(test)]
mod tests {
    use super::Angle;

    /// The values are stated in degrees, and the grid is computed in radians.
    #[test]
    fn stated_degrees_survive_the_conversion_to_radians_and_back() {
        for tenth in -3600..=3600 {
            let (half, stated) = (f64::from(tenth) / 20.0, f64::from(tenth) / 10.0);
            let radians = half.to_radians() + half.to_radians();
            assert_eq!(Angle::Degree.as_stated(radians.to_degrees()), stated);
        }
        assert!(Angle::Degree.as_stated(f64::NAN).is_nan());
    }

    #[test]
    fn other_angles_convert_to_within_rounding() {
        for angle in [0.1, 1.0 / 3.0, 2.0_f64.sqrt(), 1e-17, -1e300] {
            let off = (Angle::Degree.as_stated(angle) - angle).abs();
            assert!(off <= 4.0 * f64::EPSILON * angle.abs(), "{angle}: {off}");
            assert_eq!(Angle::Radian.as_stated(angle), angle);
        }
    }
}
