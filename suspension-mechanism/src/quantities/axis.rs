//! Components of vectors.

use std::fmt;

use nalgebra::Vector3;

/// A component of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Forward.
    X,
    /// To the left.
    Y,
    /// Upward.
    Z,
}

impl Axis {
    /// All three, in the order of a vector's components.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// The unit vector along this axis.
    pub fn vector(self) -> Vector3<f64> {
        let mut vector = Vector3::zeros();
        vector[self as usize] = 1.0;
        vector
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
        })
    }
}
