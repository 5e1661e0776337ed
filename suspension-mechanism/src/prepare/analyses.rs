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
    /// [`Failure::Input`] at the first mistake.
    pub fn check_analyses(&self, mechanism: &dyn Kinematics) -> Result<(), Failure> {
        self.load_cases(mechanism)?;
        self.tolerances(mechanism)?;
        if self.file.tune.is_some() {
            self.tuning(mechanism)?;
        }
        Ok(())
    }
}
