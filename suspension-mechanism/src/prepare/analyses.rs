//! Statements of a motion file for single analyses: load cases, sensitivities, tolerances, tuning.

mod changes;
pub(super) mod combined_changes;
mod load_cases;
mod tolerances;
mod tuning;

use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::prepare::loaded::Loaded;

impl Loaded<'_> {
    /// Checks what the file states for single analyses.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at each mistake.
    pub fn check_analyses(&self, mechanism: &dyn Kinematics) -> Result<(), Failure> {
        let tuning = match &self.file.tune {
            Some(_) => self.tuning(mechanism).map(drop),
            None => Ok(()),
        };
        let checks = [
            self.load_cases(mechanism).map(drop),
            self.tolerances(mechanism).map(drop),
            tuning,
        ];
        Failure::all(checks).map(drop)
    }
}
