//! What a motion file states for single commands: load cases and masses, tolerances, tuning.

use crate::failure::Failure;
use crate::load::cases::cases;
use crate::load::loaded::Loaded;
use crate::load::masses::masses;
use crate::load::tolerances::tolerances;
use crate::load::tuning::tuning;
use crate::loads::{Case, Mass};
use crate::mechanism::Description;
use crate::tolerances::Tolerance;
use crate::tune::{Move, Target};

impl Loaded<'_> {
    /// The load cases of the file, in its order.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] with the place of what is no load of the mechanism.
    pub fn load_cases(&self, mechanism: &Description) -> Result<Vec<Case>, Failure> {
        cases(self.source, &self.file, self.listing(), mechanism)
    }

    /// The masses of the file's parts, whose centres are stated at the design position.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] with the place of what is no mass, or of no part, and where there is no design position.
    pub fn masses(&self) -> Result<Vec<Mass>, Failure> {
        let mechanism = &*self.at_design_without_notes()?;
        let design = mechanism.points();
        masses(
            self.source,
            &self.file,
            self.listing(),
            (mechanism, &design),
        )
    }

    /// The tolerances of the file's points and links.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] with the place of what is no tolerance, or of nothing in the mechanism.
    pub fn tolerances(&self, mechanism: &Description) -> Result<Vec<Tolerance>, Failure> {
        tolerances(self.source, &self.file, self.listing(), mechanism)
    }

    /// Markers that the file states off another point, each with that one, by number.
    pub fn followers(&self, mechanism: &Description) -> Vec<[usize; 2]> {
        self.file.followers(&mechanism.names.points)
    }

    /// The named changes of the file, the moves of `[tune]`; none where it has none.
    ///
    /// # Errors
    ///
    /// As [`tuning`](Self::tuning).
    pub fn moves(&self, mechanism: &Description) -> Result<Vec<Move>, Failure> {
        match self.file.tune {
            Some(_) => Ok(self.tuning(mechanism)?.0),
            None => Ok(Vec::new()),
        }
    }

    /// What the file has for `suspension tune`: what may be moved, and the targets, in its order.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] with the place of what is none of the mechanism's, and where nothing is stated.
    pub fn tuning(&self, mechanism: &Description) -> Result<(Vec<Move>, Vec<Target>), Failure> {
        tuning(self.source, &self.file, self.listing(), mechanism)
    }
}
