//! To the first instant of a motion that its drives lead.

use suspension_core::{Motion, Values};

use crate::failure::Failure;
use crate::load::design::Design;
use crate::load::task::Task;
use crate::mechanism::{DriveLaws, Misfit, Polynomial, Suspension, follow};
use crate::number::number;

/// The drives on a straight line from the design at time 0 to the first instant at time 1.
pub(super) fn way<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    design: &Design<L, N>,
    drives: &DriveLaws,
) -> DriveLaws {
    let first = drives.inputs::<L::Drives>(task.first).drives.value;
    let ends = design.drives.values().zip(first.values());
    DriveLaws::new(ends.map(|(from, to)| Polynomial::line(from, to)))
}

pub(super) const FROM_DESIGN_TO_FIRST: [f64; 2] = [0.0, 1.0];

/// Drives the mechanism from its design to the first instant.
pub(super) fn to_first_instant<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    design: &Design<L, N>,
    drives: &DriveLaws,
) -> Result<Motion<f64, N>, Failure> {
    let way = way(task, design, drives);
    let mut motion = Motion::at_rest(design.q);
    match follow(&design.model, &way, FROM_DESIGN_TO_FIRST, &mut motion) {
        Ok(_) => Ok(motion),
        Err(stopped) => {
            let (names, unit) = (task.names, task.file.unit);
            let [reached, first] = [stopped.reached, FROM_DESIGN_TO_FIRST[1]].map(|t| {
                let drives = way.inputs::<L::Drives>(t).drives.value;
                names.drives_in_words(&design.given(&drives), unit, None)
            });
            let cause = stopped.refused.map(|(_, error)| names.cause(&error));
            let times = [stopped.reached, FROM_DESIGN_TO_FIRST[1]];
            let misfit = Misfit::between(&design.model, &way, times, &motion.position);
            let misfit = misfit.and_then(|misfit| misfit.in_words(unit));
            Err(out_of_reach(task, [&first, &reached], cause, misfit))
        }
    }
}

/// The first instant, in words, cannot be reached: how far, and why no further.
pub(super) fn out_of_reach(
    task: &Task<'_>,
    [first, reached]: [&str; 2],
    cause: Option<String>,
    misfit: Option<String>,
) -> Failure {
    let misfit = misfit.map_or_else(String::new, |misfit| format!("; {misfit}"));
    Failure::Solver(format!(
        "{}: the first instant, t = {} s with {first}, is out of reach: driven there from the \
         design position, the mechanism stops at {reached} ({}){misfit}",
        task.source.name(),
        number(task.first),
        cause.unwrap_or_default(),
    ))
}
