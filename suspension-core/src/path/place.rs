//! Events along a curve.

use crate::path::configuration::Configuration;

/// A place on a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place<T, const N: usize> {
    /// The unknowns, and the coordinate of the free drive.
    pub configuration: Configuration<T, N>,
    /// The tangent of unit length, in the direction of travel. Where its entry of the drive is
    /// zero the drive turns.
    pub tangent: Configuration<T, N>,
    /// The drive's value: an angle in radians, or the coordinate itself.
    pub value: T,
    /// The largest residual, in units of length.
    pub residual: T,
    /// The entry with the largest part in the tangent: the parameter from here on.
    pub(crate) parameter: usize,
    /// See [`Linear::is_positive`](super::linear::Linear::is_positive).
    pub(crate) positive: bool,
}

/// A stretch of a curve, from the place before to `place`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch<T, const N: usize> {
    /// Where within the stretch the drive turns: at most one such place.
    pub turning: Option<Turning<T, N>>,
    /// Its end.
    pub place: Place<T, N>,
    /// Why the path ends here; `None` where it goes on.
    pub end: Option<End<T>>,
}

/// Where the free drive's coordinate is largest or smallest: driven by it, the mechanism goes no
/// further.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turning<T, const N: usize> {
    /// Where it is, with the drive's value there.
    pub place: Place<T, N>,
    /// Whether it is so because the angle itself is 0 or pi there, or about an axis a whole turn, to rounding, and
    /// not because the mechanism locks.
    pub is_end_of_angle: bool,
}

/// Why a path ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End<T> {
    /// The curve is closed: this is its start again.
    Closed {
        /// The distance between the start and its return, in all entries together.
        gap: T,
    },
    /// The derivative of the equations loses rank within `accuracy` ahead, and not because the
    /// drive turns: another curve crosses, and the mechanism can go either way.
    Bifurcation {
        /// In units of length, along the curve.
        accuracy: T,
    },
    /// The drive is at a bound of the range that was asked for.
    Range,
    /// The path's start lies outside the range that was asked for: no step is made.
    OutOfRange,
    /// All steps that were allowed are made.
    Steps,
}
