//! The unit of lengths.

use serde::Deserialize;
use suspension_core::listing::{DriveKind, MeasureKind};

/// A unit of length.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
pub enum Unit {
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

impl Unit {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Metre, Self::Millimetre, Self::Inch];

    /// The one in which something of the size of a suspension is so large.
    pub fn of_size(size: f64) -> Self {
        let off = |unit: &Self| (size / unit.metre()).ln().abs();
        let nearest = Self::ALL
            .into_iter()
            .min_by(|a, b| off(a).total_cmp(&off(b)));
        nearest.unwrap_or(Self::Metre)
    }

    /// Its symbol.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Metre => "m",
            Self::Millimetre => "mm",
            Self::Inch => "in",
        }
    }

    /// What it is called in a sentence.
    pub fn in_words(self) -> &'static str {
        match self {
            Self::Inch => "inches",
            metric => metric.symbol(),
        }
    }

    /// A metre in this unit.
    pub fn metre(self) -> f64 {
        match self {
            Self::Metre => 1.0,
            Self::Millimetre => 1000.0,
            Self::Inch => 1.0 / 0.0254,
        }
    }

    /// Decimals of a length in a table for people: a hundredth of a millimetre, or finer.
    pub fn decimals(self) -> usize {
        match self {
            Self::Metre => 5,
            Self::Millimetre => 2,
            Self::Inch => 4,
        }
    }

    /// The symbol of a drive's unit.
    pub fn of_drive(self, kind: DriveKind) -> &'static str {
        match kind {
            DriveKind::Angle => "rad",
            DriveKind::Coordinate => self.symbol(),
        }
    }

    /// The symbol of a measure's unit.
    pub fn of_measure(self, kind: MeasureKind) -> &'static str {
        match kind {
            MeasureKind::Angle => "rad",
            MeasureKind::Length => self.symbol(),
        }
    }
}
