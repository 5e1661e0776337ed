//! The directions of the axes.

use std::ops::Neg;

use nalgebra::{Scalar, Vector3};
use serde::Deserialize;

/// The directions of x, y and z. All are right-handed and differ by half a turn about an axis.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
pub enum Axes {
    /// ISO 8855: x forward, y left, z up.
    #[default]
    #[serde(rename = "ISO 8855")]
    Iso,
    /// Adams/Car and Lotus: x rearward, y right, z up.
    Adams,
    /// SAE J670: x forward, y right, z down.
    #[serde(rename = "SAE")]
    Sae,
}

impl Axes {
    /// All directions.
    pub const ALL: [Self; 3] = [Self::Iso, Self::Adams, Self::Sae];

    /// The name in motion files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Iso => "ISO 8855",
            Self::Adams => "Adams",
            Self::Sae => "SAE",
        }
    }

    /// The name as an option of the command line.
    pub fn option(self) -> &'static str {
        match self {
            Self::Iso => "iso",
            Self::Adams => "adams",
            Self::Sae => "sae",
        }
    }

    /// The directions in words.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Iso => "x forward, y left, z up",
            Self::Adams => "x rearward, y right, z up",
            Self::Sae => "x forward, y right, z down",
        }
    }

    /// Name and directions in words.
    pub fn in_words(self) -> String {
        format!("{}: {}", self.name(), self.meaning())
    }

    /// The signs of the coordinates relative to ISO 8855, for the conversion in either direction.
    pub fn signs(self) -> [f64; 3] {
        self.turned(Vector3::repeat(1.0)).into()
    }

    /// Converts a vector from ISO 8855 to these axes, or from them to ISO 8855: both are the same half turn.
    pub fn turned<N: Scalar + Neg<Output = N>>(self, vector: Vector3<N>) -> Vector3<N> {
        let [x, y, z] = vector.into();
        match self {
            Self::Iso => Vector3::new(x, y, z),
            Self::Adams => Vector3::new(-x, -y, z),
            Self::Sae => Vector3::new(x, -y, -z),
        }
    }
}
