//! From the design to the first instant of a motion that its drives lead.

pub(super) mod by_measure;

use suspension_core::{Motion, Values};

use crate::failure::Failure;
use crate::mechanism::{DriveLaws, Law, Lock, Suspension, follow};
use crate::number::number;
use crate::prepare::design::Design;
use crate::prepare::task::Task;

/// The drives on a straight line from the design at time 0 to the first instant at time 1.
pub(super) fn line_from_design<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    design: &Design<L, N>,
    drives: &DriveLaws,
) -> DriveLaws {
    let first = drives.inputs::<L::Drives>(task.first).drives.value;
    let ends = design.drives.values().zip(first.values());
    DriveLaws::new(ends.map(|(from, to)| Law::line(from, to)))
}

/// From where an instant is out of reach, in words.
pub(super) const FROM_DESIGN: &str = " from the design position";

pub(super) const FROM_DESIGN_TO_FIRST: [f64; 2] = [0.0, 1.0];

/// Drives the mechanism from its design to the first instant.
pub(super) fn drive_to_first_instant<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    design: &Design<L, N>,
    drives: &DriveLaws,
) -> Result<Motion<f64, N>, Failure> {
    let way = line_from_design(task, design, drives);
    let mut motion = Motion::at_rest(design.q);
    match follow(&design.model, &way, FROM_DESIGN_TO_FIRST, &mut motion) {
        Ok(_) => Ok(motion),
        Err(stopped) => {
            let (names, unit) = (&task.names, task.file.unit());
            let [_, asked] = FROM_DESIGN_TO_FIRST;
            let given = |drives: &L::Drives| design.drives_in_file(drives);
            let first = given(&way.inputs::<L::Drives>(asked).drives.value);
            let last = &motion.position;
            let lock = Lock::new(&design.model, names, &way, &stopped, asked, last, given);
            let at_design = given(&design.drives);
            let from = (!lock.is_at(&at_design)).then_some(FROM_DESIGN);
            let remedy = lock.remedy(&at_design)(task.source.name());
            let lock = lock.in_words(names, unit, &at_design);
            let first = names.drives_in_words(&first, unit, None);
            let cause = format!("{}: {lock}; {remedy}", from.unwrap_or_default());
            Err(out_of_reach(task, &first, &cause))
        }
    }
}

/// The failure that the first instant, in words, cannot be reached, with from where and why.
pub(super) fn out_of_reach(task: &Task<'_>, first: &str, cause: &str) -> Failure {
    Failure::Solver(format!(
        "{}: the first instant, t = {} s with {first}, is out of reach{cause}",
        task.source.name(),
        number(task.first),
    ))
}
