//! A motion along its drive or measure, at any place.

use std::fmt;

use suspension_core::SolveError;

use crate::bake::driven::{Derivatives, Output};
use crate::number::number;

/// The value at which a mechanism stopped, and the reason.
pub(super) type Stop = (f64, Option<SolveError<f64>>);

/// The mechanism does not go through the range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfReach {
    /// The first and last values of the drive that the mechanism reaches towards the range.
    pub reached: [f64; 2],
    /// The reason why it goes no further.
    pub cause: Option<SolveError<f64>>,
}

impl fmt::Display for OutOfReach {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [from, to] = self.reached.map(number);
        write!(f, "the drive moves the mechanism only from {from} to {to}")?;
        self.cause.map_or(Ok(()), |cause| write!(f, ": {cause}"))
    }
}

impl std::error::Error for OutOfReach {}

impl OutOfReach {
    /// The failure on a way that began at a value.
    pub(super) fn from_stop(from: f64, (reached, cause): Stop) -> Self {
        Self {
            reached: [from, reached],
            cause,
        }
    }
}

/// A motion along a drive, independent of its linkage.
pub trait Exact {
    /// The outputs.
    fn outputs(&self) -> Vec<Output>;

    /// The outputs when the drive has the value `at`.
    ///
    /// # Errors
    ///
    /// [`OutOfReach`].
    fn at(&self, at: f64) -> Result<Vec<Derivatives>, OutOfReach>;
}
