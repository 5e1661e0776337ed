//! The axes of a hardpoint file, and how they are turned to ours.

use clap::ValueEnum;

/// Which way x, y and z point. All are right-handed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Axes {
    /// ISO 8855: x forward, y left, z up.
    Iso,
    /// Adams/Car and Lotus: x rearward, y right, z up.
    Adams,
    /// SAE J670: x forward, y right, z down.
    Sae,
}

impl Axes {
    pub(super) const ALL: [Self; 3] = [Self::Iso, Self::Adams, Self::Sae];

    /// Name and meaning.
    pub(super) fn in_words(self) -> &'static str {
        match self {
            Self::Iso => "iso (x forward, y left, z up)",
            Self::Adams => "adams (x rearward, y right, z up)",
            Self::Sae => "sae (x forward, y right, z down)",
        }
    }

    /// What was done to the coordinates, in words.
    pub(super) fn turned(self) -> &'static str {
        match self {
            Self::Iso => "coordinates are those of the file",
            Self::Adams => "x and y have changed their signs",
            Self::Sae => "y and z have changed their signs",
        }
    }

    /// By what the coordinates are multiplied, to ISO 8855.
    pub(super) fn signs(self) -> [f64; 3] {
        match self {
            Self::Iso => [1.0, 1.0, 1.0],
            Self::Adams => [-1.0, -1.0, 1.0],
            Self::Sae => [1.0, -1.0, -1.0],
        }
    }

    /// To ISO 8855.
    pub(super) fn to_iso(self, at: [f64; 3]) -> [f64; 3] {
        let signs = self.signs();
        // A zero keeps no sign.
        [0, 1, 2].map(|axis| signs[axis] * at[axis] + 0.0)
    }
}
