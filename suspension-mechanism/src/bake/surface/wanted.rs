//! The motion of two drives to bake, and the reasons for which it may be refused.

use std::fmt;

use suspension_core::SolveError;

use crate::bake::driven::RequestedPoints;
use crate::number::number;

/// The request for a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WantedSurface {
    /// The numbers of the two drives.
    pub drives: [usize; 2],
    /// Each drive's first and last value.
    pub ranges: [[f64; 2]; 2],
    /// The largest permitted error of a point, in the unit of the hardpoints.
    pub tolerance: f64,
    /// A metre in that unit: the spin axis may have the same error as a point a metre away.
    pub metre: f64,
    /// Whether velocities are continuous where patches join. Accelerations are not.
    pub smooth: bool,
    /// The points to bake.
    pub points: RequestedPoints,
}

/// The largest number of patches of a surface.
pub const MOST_PATCHES: usize = 144;

/// The reason why a motion of two drives was not baked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum UnmetSurface {
    /// The mechanism does not reach these values of the drives.
    OutOfReach {
        /// The values.
        drives: [f64; 2],
        /// The reason.
        cause: Option<SolveError<f64>>,
    },
    /// The tolerance is not met with [`MOST_PATCHES`].
    TooManyPatches,
    /// The user has interrupted it.
    Interrupted,
}

impl fmt::Display for UnmetSurface {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfReach { drives, cause } => {
                let [first, second] = drives.map(number);
                write!(f, "the mechanism does not reach {first} and {second}")?;
                cause.map_or(Ok(()), |cause| write!(f, ": {cause}"))
            }
            Self::TooManyPatches => {
                write!(f, "{MOST_PATCHES} patches do not meet the tolerance")
            }
            Self::Interrupted => f.write_str("interrupted"),
        }
    }
}

impl std::error::Error for UnmetSurface {}
