//! The configuration found from a guess.

use crate::solve::report::Report;

/// A configuration that was found, and how it relates to the guess.
///
/// Distances are the norm over all coordinates of free points, in units of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assembly<T> {
    /// How it was found, from the start that led to it.
    pub report: Report<T>,
    /// How far it lies from the guess.
    pub distance: T,
    /// How far the next nearest root that was met lies from the guess; `None` where all that was met
    /// is this one. Where the two are nearly alike the guess does not tell which is meant.
    pub next: Option<T>,
    /// How many of the [`STARTS`](super::STARTS) led to it.
    pub starts: usize,
}
