//! Why a step was refused, in words.

use suspension_core::SolveError;

use crate::input::file::Unit;
use crate::number::{number, rounded};
use crate::study::Suspension;

/// Why a step was refused, with the listing's names.
pub fn cause<L: Suspension<N>, const N: usize>(error: &SolveError<f64>, unit: Unit) -> String {
    let listing = L::Listing::default();
    let name = error.culprit(&listing);
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
