//! From the design to the first instant of a motion that a measure leads.

use suspension_core::Values;
use suspension_core::path::{Curve, Led};

use crate::failure::Failure;
use crate::file::LeadingMeasure;
use crate::mechanism::{DriveLaws, Law, Lead, Suspension};
use crate::prepare::design::Design;
use crate::prepare::first_instant::{
    FROM_DESIGN, FROM_DESIGN_TO_FIRST, line_from_design, out_of_reach,
};
use crate::prepare::task::Task;

/// Leads the mechanism from its design to the first instant, with the measure and the remaining drives on a straight
/// line.
pub(crate) fn lead_to_first_instant<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    design: &Design<L, N>,
    drives: &DriveLaws,
    leading: &LeadingMeasure,
) -> Result<Lead<N>, Failure> {
    let way = line_from_design(task, design, drives);
    let mut led = at_rest(task, design, &way, leading.drive)?;
    let points = led.points(&design.model, &way.inputs::<L::Drives>(0.0));
    let measured = |all: L::Measures| all.values().nth(leading.measure).unwrap_or_default();
    let offset = measured(task.origin.of_measures(&design.model));
    let law = law(task, leading, offset)?;
    let ends = [
        measured(design.model.measures(&points).value),
        law.at(task.first).value,
    ];
    let lead = Lead {
        measure: leading.measure,
        drive: leading.drive,
        law: Law::line(ends[0], ends[1]),
        offset,
        start: led,
    };
    match lead.follow(&design.model, &way, FROM_DESIGN_TO_FIRST, &mut led) {
        Ok(_) => Ok(Lead {
            law,
            start: led,
            ..lead
        }),
        Err(stopped) => {
            let (names, unit) = (&task.names, task.file.unit());
            let [reached, first] = [stopped.reached, FROM_DESIGN_TO_FIRST[1]].map(|t| {
                let drives = way.inputs::<L::Drives>(t).drives.value;
                lead.in_words(names, &design.drives_in_file(&drives), t, unit)
            });
            let cause = stopped.refused;
            let cause = cause.map(|(_, error)| lead.cause(names, &error, unit));
            let cause = cause.unwrap_or_default();
            let cause =
                format!("{FROM_DESIGN}: the mechanism goes no further than {reached} ({cause})");
            Err(out_of_reach(task, &first, &cause))
        }
    }
}

/// The mechanism at rest in the design position, with one drive free.
fn at_rest<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    design: &Design<L, N>,
    way: &DriveLaws,
    drive: usize,
) -> Result<Led<f64, N>, Failure> {
    let name = task.source.name();
    let inputs = way.inputs::<L::Drives>(0.0);
    let curve = Curve::new(&design.model, &inputs, drive)
        .ok_or_else(|| Failure::Solver(format!("{name}: no such drive")))?;
    Led::at_rest(&curve, &design.q).map_err(|error| {
        let cause = task.names.cause(&error);
        Failure::Solver(format!(
            "{name}: a measure cannot replace a drive at the design position: {cause}"
        ))
    })
}

/// The measure over time according to the file, for points in local coordinates.
fn law(task: &Task<'_>, leading: &LeadingMeasure, offset: f64) -> Result<Law, Failure> {
    let stated = &task.file.drives.get_ref()[leading.key.get_ref().as_str()];
    let kind = task.names.measures[leading.measure].kind;
    task.law(stated, kind, offset)
}
