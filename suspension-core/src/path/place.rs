//! Events along a curve.

use crate::path::configuration::Configuration;

/// A place on a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place<T, const N: usize> {
    /// The unknowns, and the coordinate of the free drive.
    pub configuration: Configuration<T, N>,
    /// The unit tangent, in the direction of travel. The drive turns where its entry of the tangent is zero.
    pub tangent: Configuration<T, N>,
    /// The drive's value: an angle in radians, or the coordinate itself.
    pub value: T,
    /// The largest residual, in units of length.
    pub residual: T,
    /// The entry with the largest component in the tangent: the parameter from here on.
    pub(crate) parameter: usize,
    /// See [`Linear::is_positive`](super::linear::Linear::is_positive).
    pub(crate) positive: bool,
}

/// A stretch of a curve, from the previous place to `place`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch<T, const N: usize> {
    /// The place within the stretch where the drive turns, of which there is at most one.
    pub turning: Option<Turning<T, N>>,
    /// Its end.
    pub place: Place<T, N>,
    /// Why the path ends here; `None` if it goes on.
    pub end: Option<End<T>>,
}

/// A place where the free drive's coordinate is largest or smallest: driven by it, the mechanism goes no further.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turning<T, const N: usize> {
    /// The place on the curve, with the drive's value there.
    pub place: Place<T, N>,
    /// Whether the cause is that the angle itself is 0 or pi there, or a whole turn about an axis, to rounding, and
    /// not that the mechanism locks.
    pub is_end_of_angle: bool,
}

/// Why a path ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End<T> {
    /// The curve is closed: this is its start again.
    Closed {
        /// The distance between the start and the return to it, over all entries together.
        gap: T,
    },
    /// The derivative of the equations loses rank within `accuracy` ahead, and not because the drive turns: another
    /// curve crosses, and the mechanism can go either way.
    Bifurcation {
        /// A distance along the curve, in units of length.
        accuracy: T,
    },
    /// The drive is at a bound of the requested range.
    Range,
    /// The path's start is outside the requested range: no step is made.
    OutOfRange,
    /// All permitted steps are made.
    Steps,
}
