//! Errors in the geometry of a linkage.

use super::{Cause, Explain, Facts};
use crate::listing::Part;

/// Why a linkage cannot be built. Numbers are indices of parts of the listing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GeometryError {
    /// A coordinate of the point is NaN or infinite.
    NotFinite {
        /// The point.
        point: usize,
    },
    /// The length is zero, negative or NaN, or too large or too small to compute with.
    BadLength {
        /// The length.
        length: usize,
    },
    /// The three points that should carry the point are collinear.
    Collinear {
        /// The point carried, or the last of the three.
        point: usize,
    },
    /// The point lies in the plane of the three points that links join it to, or too near to tell its sides apart:
    /// the distances are singular there. A `body` has no such singularity.
    Flat {
        /// The point.
        point: usize,
    },
    /// The ends of a line on which a point slides, of a driven length or of a line at an angle coincide or are too far
    /// apart to compute with, or the line lies along the axis of its angle.
    NoLine {
        /// The end of the line.
        point: usize,
    },
    /// No rigid body has the given lengths: at this point they break the triangle inequality, or its counterpart in
    /// space.
    NotClosed {
        /// The point.
        point: usize,
    },
    /// The fixed order of elimination has too small a pivot at these points, while partial pivoting has none: see
    /// [`Build::check_pivots`](crate::Build::check_pivots).
    SmallPivot {
        /// The equation of the pivot.
        equation: usize,
    },
    /// Within the rounding errors of the points the equations do not determine the motion: the mechanism locks there, or a
    /// drive has no effect, so that a step of a [`Corner`](crate::Corner) there would be refused as
    /// [`SolveError::Singular`](crate::SolveError::Singular). There may be a model of them all the same:
    /// [`assemble`](crate::assemble) may lead it elsewhere.
    Singular {
        /// The unknown that the equations determine least.
        unknown: usize,
    },
}

impl GeometryError {
    /// The point, length, equation or unknown concerned.
    pub fn part(&self) -> Part {
        match *self {
            Self::NotFinite { point }
            | Self::Collinear { point }
            | Self::Flat { point }
            | Self::NoLine { point }
            | Self::NotClosed { point } => Part::Point(point),
            Self::BadLength { length } => Part::Length(length),
            Self::SmallPivot { equation } => Part::Equation(equation),
            Self::Singular { unknown } => Part::Unknown(unknown),
        }
    }
}

impl Explain for GeometryError {
    fn facts(&self) -> Facts {
        let cause = match self {
            Self::NotFinite { .. } => Cause::PointNotFinite,
            Self::BadLength { .. } => Cause::BadLength,
            Self::Collinear { .. } => Cause::Collinear,
            Self::Flat { .. } => Cause::Flat,
            Self::NotClosed { .. } => Cause::NotClosed,
            Self::NoLine { .. } => Cause::NoLine,
            Self::SmallPivot { .. } => Cause::SmallPivot,
            Self::Singular { .. } => Cause::SingularDesign,
        };
        Facts::new(cause, Some(self.part()))
    }
}
