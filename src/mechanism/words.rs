//! Names and values in messages.

use suspension_core::SolveError;

use crate::mechanism::names::Names;
use crate::mechanism::unit::Unit;
use crate::number::{number, rounded};

impl Names {
    /// A drive's value in words, as `theta = 0.7 rad`.
    pub fn drive_in_words(&self, drive: usize, value: f64, unit: Unit) -> String {
        let drive = &self.drives[drive];
        let unit = unit.of_drive(drive.kind);
        format!("{} = {} {unit}", drive.name, number(value))
    }

    /// All drives' values in words, `instead` in place of one of them.
    pub fn drives_in_words(
        &self,
        values: &[f64],
        unit: Unit,
        instead: Option<(usize, &str)>,
    ) -> String {
        let each = values
            .iter()
            .enumerate()
            .map(|(drive, value)| match instead {
                Some((other, words)) if other == drive => words.to_owned(),
                _ => self.drive_in_words(drive, *value, unit),
            });
        each.collect::<Vec<_>>().join(", ")
    }

    /// Why a step was refused.
    pub fn cause(&self, error: &SolveError<f64>, unit: Unit) -> String {
        let name = error.culprit(self);
        let unit = unit.symbol();
        match error {
            SolveError::NotFinite { .. } => {
                format!("the residual of equation `{name}` is not a finite number")
            }
            SolveError::Overflow { .. } => {
                format!("the change of unknown `{name}` is not a finite number")
            }
            SolveError::CrossedSingularity { .. } => {
                format!("a step of unknown `{name}` ended in another assembly")
            }
            SolveError::Mirrored { .. } => format!(
                "point `{name}` would stand on the wrong side of the points that links join it to"
            ),
            SolveError::TooFar { .. } => {
                format!("the step of unknown `{name}` is too long to tell assemblies apart")
            }
            SolveError::Singular { .. } => format!("unknown `{name}` is no longer determined"),
            SolveError::Diverging { .. } => {
                format!("no root near by, the corrections of unknown `{name}` do not shrink")
            }
            SolveError::StepTooLong { .. } => {
                format!("the series of unknown `{name}` is not good for so long a step")
            }
            SolveError::TurningPoint { asked, extreme, .. } => format!(
                "the leading quantity turns at {}, on the way to {}",
                number(*extreme),
                number(*asked)
            ),
            SolveError::NotConverged {
                residual,
                iterations,
                ..
            } => format!(
                "equation `{name}` is still off by {} {unit} after {iterations} iterations",
                rounded(*residual, 2)
            ),
        }
    }
}
