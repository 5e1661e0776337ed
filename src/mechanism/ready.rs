//! A linkage in the configuration of the first instant, with its drives over time.

use suspension_core::{LocalOrigin, Motion, Values};

use crate::failure::Failure;
use crate::mechanism::drives::{DriveLaws, given};
use crate::mechanism::instants::Instants;
use crate::mechanism::lead::Lead;
use crate::mechanism::names::{Names, Suspension};
use crate::mechanism::unit::Unit;

/// A linkage in the configuration of the first instant, with its drives over time.
#[derive(Clone, Debug)]
pub struct Mechanism<L, const N: usize> {
    /// The linkage's name in motion files.
    pub linkage: String,
    /// The names of its parts.
    pub names: Names,
    /// The unit of its lengths.
    pub unit: Unit,
    /// Where the file's coordinates have the origin of all below.
    pub origin: LocalOrigin<f64>,
    /// The geometry.
    pub model: L,
    /// The instants of its motion.
    pub instants: Instants,
    /// The configuration at the first of them.
    pub start: Motion<f64, N>,
    /// The drives; one for which a measure leads stays as it is there.
    pub drives: DriveLaws,
    /// The drives at the design position, in the file's coordinates.
    pub design: Vec<f64>,
    /// The measure that leads in place of a drive.
    pub lead: Option<Lead<N>>,
    /// What the file says that its author may not have meant, a sentence each.
    pub notes: Vec<String>,
}

/// Work on a mechanism, whatever its linkage: what a command is.
pub trait Work {
    /// What comes of it.
    type Answer;

    /// Whether it tells the mechanism's notes itself; else standard error has them.
    const TELLS_NOTES: bool = false;

    /// Does the work.
    ///
    /// # Errors
    ///
    /// See [`Failure`].
    fn on<L: Suspension<N>, const N: usize>(
        self,
        mechanism: &Mechanism<L, N>,
    ) -> Result<Self::Answer, Failure>;
}

impl<L: Suspension<N>, const N: usize> Mechanism<L, N> {
    /// The drives' values in the file's coordinates, from local ones.
    pub fn given(&self, local: &L::Drives) -> Vec<f64> {
        given(&self.origin, &self.model, local)
    }

    /// What a drive has more in the file's coordinates.
    pub fn drive_offset(&self, drive: usize) -> f64 {
        let offsets = self.origin.of_drives(&self.model);
        offsets.values().nth(drive).unwrap_or_default()
    }
}
