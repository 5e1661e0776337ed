//! The configuration found from a guess.

use crate::solve::report::Report;

/// A configuration that was found, and its relation to the guess.
///
/// Distances are the norm over all coordinates of free points, in units of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assembly<T> {
    /// The report of the start that led to it.
    pub report: Report<T>,
    /// Its distance from the guess.
    pub distance: T,
    /// The distance from the guess to the next nearest root that was found; `None` if no other root was found. If the
    /// two distances are nearly equal, the guess does not tell which root is meant.
    pub next: Option<T>,
    /// The number of the [`STARTS`](super::STARTS) that led to it.
    pub starts: usize,
}
