//! A request to load a file.

use suspension_runtime::Listing;

use crate::file::{MotionFile, Source};
use crate::mechanism::Instants;

/// What is to be prepared.
#[derive(Clone, Copy)]
pub(super) struct Request<'a> {
    pub(super) source: &'a Source,
    pub(super) file: &'a MotionFile,
    /// Its listing, where that was read while the program runs.
    pub(super) listing: Option<&'a Listing>,
    pub(super) instants: &'a Instants,
    pub(super) to: Start,
}

/// Where a mechanism is when work on it starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Start {
    /// At the first instant of its motion.
    FirstInstant,
    /// There; where that is out of reach at the design position, with a note.
    WithinReach,
    /// At the design position, where drives, not a measure, hold it.
    Design,
}
