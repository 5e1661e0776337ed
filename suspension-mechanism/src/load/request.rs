//! A request to load a file.

use suspension_runtime::Listing;

use crate::file::{MotionFile, Source};
use crate::mechanism::Instants;

/// The mechanism to be prepared.
#[derive(Clone, Copy)]
pub(super) struct Request<'a> {
    pub(super) source: &'a Source,
    pub(super) file: &'a MotionFile,
    /// Its listing, if that was read at run time.
    pub(super) listing: Option<&'a Listing>,
    pub(super) instants: &'a Instants,
    pub(super) to: Start,
}

/// The place of a mechanism when work on it starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Start {
    /// The first instant of its motion.
    FirstInstant,
    /// The first instant or, if that is out of reach, the design position, with a note.
    WithinReach,
    /// The design position, held by drives and not by a measure.
    Design,
}
