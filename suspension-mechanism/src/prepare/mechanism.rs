//! From the contents of a file to a mechanism in the configuration of the first instant.

use nalgebra::Vector3;
use suspension_core::{Motion, Values};

use crate::failure::Failure;
use crate::file::LeadingMeasure;
use crate::mechanism::{
    Description, DriveLaws, Instants, Lead, Mechanism, Names, Suspension, Vehicle,
};
use crate::prepare::assembled::{Assembled, Measured};
use crate::prepare::column_names;
use crate::prepare::design::Design;
use crate::prepare::first_instant::{self, by_measure};
use crate::prepare::notes::{
    contradicted_drives, contradicted_wheels, loose_markers, missing_travel, neither_side, notes,
    of_neither_axle, one_sided_masses, short_of_stop, unlikely_masses, untwisted_bars, wrong_side,
};
use crate::prepare::task::{Request, Start, Task};
use crate::prepare::vehicle::coupling::couplings;
use crate::prepare::vehicle::masses::masses;
use crate::prepare::vehicle::springs::springs;
use crate::prepare::vehicle::steering_wheel::steering_wheel;
use crate::prepare::vehicle::usual_drives::effective_names;

/// The mechanism of a file and a listing.
pub(super) fn prepare<L: Suspension<N>, const N: usize>(
    request: Request<'_>,
    linkage: &str,
    listing: L::Listing,
) -> Result<Mechanism<L, N>, Failure> {
    let assembled = Assembled::<L, N>::new(&request, listing)?;
    let (task, design) = (&assembled.task, &assembled.design);
    let measured = assembled.measured();
    let (names, of_drives) = complete_names(&assembled, &measured)?;
    let drives = task.drive_laws(&design.drive_offsets, &design.drives)?;
    let doubts = doubts(&assembled, &drives, request.instants);
    let outlier = assembled.outlier.iter();
    let mut notes: Vec<String> = outlier.map(|outlier| outlier.note(task.source)).collect();
    let remarks = remarks(&assembled, &request, &names);
    notes.extend(task.of_file(remarks.into_iter().chain(of_drives)));
    notes.extend(doubts.iter().cloned());
    let first = drives.inputs::<L::Drives>(task.first).drives.value;
    task.check_angles(first.values(), &task.file.drives)?;
    let begin = Begin::find(&assembled, request.to, drives, (&doubts, &mut notes))?;
    column_names::check(request.source, &names, task.file.unit())?;
    let drive_offsets = design.drive_offsets.values().take(names.drives.len());
    let description = Description {
        linkage: linkage.to_owned(),
        unit: task.file.unit(),
        axes: task.file.axes,
        origin: task.origin.position(),
        instants: request.instants.clone(),
        drives: begin.drives,
        drive_offsets: drive_offsets.collect(),
        measure_offsets: measured.offsets,
        design: design.drives_in_file(&design.drives),
        design_measures: measured.in_file,
        out_of_reach: begin.out_of_reach,
        led_by: begin.lead.as_ref().map(|lead| lead.measure),
        names,
        notes,
    };
    Ok(Mechanism {
        description,
        model: assembled.design.model,
        start: begin.start,
        lead: begin.lead,
        design_derivatives: None,
    })
}

/// The names of all parts with everything that the file and the design say of them, and notes on drives that have the
/// usual names.
fn complete_names<L: Suspension<N>, const N: usize>(
    assembled: &Assembled<'_, L, N>,
    measured: &Measured,
) -> Result<(Names, Vec<String>), Failure> {
    let (task, design) = (&assembled.task, &assembled.design);
    let springs = springs(task, &measured.in_file);
    let masses = task.listing.map_or(Ok(Vec::new()), |listing| {
        let origin = task.origin.position();
        masses(task, listing, (origin, &assembled.points_in_file()))
    });
    let (springs, masses) = Failure::both(springs, masses)?;
    let (names, of_drives) = effective_names(task, design);
    let steering_wheel = steering_wheel(task, &names, design)?;
    let couplings = couplings(&names, design);
    let points: Vec<_> = design.points.values().take(names.points.len()).collect();
    let mut names = names.designed(&points);
    for (wheel, coupling) in names.wheels.iter_mut().zip(couplings) {
        wheel.is_in_middle = is_in_middle(task, wheel.points.axis.map(|end| points[end]));
        wheel.coupling = coupling;
    }
    names.vehicle = Vehicle {
        steering_wheel,
        springs: springs.into(),
        masses: masses.into(),
        ..names.vehicle
    };
    Ok((names, of_drives))
}

/// Whether the wheel with this spin axis is in the middle of the vehicle.
fn is_in_middle(task: &Task<'_>, [inner, centre]: [Vector3<f64>; 2]) -> bool {
    /// A fraction of the length of the spin axis.
    const ROUNDING: f64 = 1e-6;
    task.y_in_file(&centre).abs() < ROUNDING * (centre - inner).norm()
}

/// Descriptions of what is probably a mistake; if a point is probably wrong, only that.
fn doubts<L: Suspension<N>, const N: usize>(
    assembled: &Assembled<'_, L, N>,
    drives: &DriveLaws,
    instants: &Instants,
) -> Vec<String> {
    if assembled.outlier.is_some() {
        return Vec::new();
    }
    let task = &assembled.task;
    let mut doubts = contradicted_drives::doubts(task, &assembled.design, drives, instants);
    doubts.extend(wrong_side::notes(task, &assembled.given));
    task.of_file(doubts).collect()
}

/// Remarks on a file whose mechanism has the given names.
fn remarks<L: Suspension<N>, const N: usize>(
    assembled: &Assembled<'_, L, N>,
    request: &Request<'_>,
    names: &Names,
) -> Vec<String> {
    let (task, design) = (&assembled.task, &assembled.design);
    let (given, has_outlier) = (&assembled.given, assembled.outlier.is_some());
    let mut notes = notes(task, given, &design.points, design.off, has_outlier);
    if let Some(listing) = task.listing {
        notes.extend(loose_markers(task, design, listing));
        notes.extend(one_sided_masses::note(task, listing));
        notes.extend(neither_side::notes(task, listing, given));
        notes.extend(untwisted_bars::notes(names, design, listing));
    }
    notes.extend(contradicted_wheels::notes(task, design, names));
    notes.extend(missing_travel::note(task, names));
    notes.extend(of_neither_axle::note(task));
    notes.extend(unlikely_masses::notes(task, names));
    if request.to != Start::Design {
        notes.extend(short_of_stop(task, request.instants));
    }
    notes
}

/// The place where work on a mechanism begins.
struct Begin<const N: usize> {
    start: Motion<f64, N>,
    drives: DriveLaws,
    lead: Option<Lead<N>>,
    out_of_reach: Option<String>,
}

impl<const N: usize> Begin<N> {
    /// The start of a motion by `drives`, which may be mistaken according to `doubts`; if it is out of reach and may
    /// be so, that is one more note.
    fn find<L: Suspension<N>>(
        assembled: &Assembled<'_, L, N>,
        to: Start,
        drives: DriveLaws,
        (doubts, notes): (&[String], &mut Vec<String>),
    ) -> Result<Self, Failure> {
        let at_design = Self::at_design(&assembled.design);
        let begin = match &assembled.leading_measure {
            _ if to == Start::Design => return Ok(at_design),
            Some(leading) => Self::led(assembled, leading, &drives),
            None => Self::driven(assembled, drives),
        };
        match begin {
            Err(Failure::Solver(why)) if to == Start::WithinReach => {
                notes.push(format!("{why}; it stays at the design position"));
                Ok(Self {
                    out_of_reach: Some(why),
                    ..at_design
                })
            }
            begin => begin.map_err(|unreached| {
                assembled.outlier_first(doubts.iter().fold(unreached, doubted))
            }),
        }
    }

    /// The first instant of a motion that drives lead.
    fn driven<L: Suspension<N>>(
        assembled: &Assembled<'_, L, N>,
        drives: DriveLaws,
    ) -> Result<Self, Failure> {
        let start =
            first_instant::drive_to_first_instant(&assembled.task, &assembled.design, &drives)?;
        Ok(Self {
            start,
            drives,
            lead: None,
            out_of_reach: None,
        })
    }

    /// The first instant of a motion that a measure leads.
    fn led<L: Suspension<N>>(
        assembled: &Assembled<'_, L, N>,
        leading: &LeadingMeasure,
        drives: &DriveLaws,
    ) -> Result<Self, Failure> {
        let (task, design) = (&assembled.task, &assembled.design);
        let lead = by_measure::lead_to_first_instant(task, design, drives, leading)?;
        let inputs = drives.inputs(task.first);
        let there = lead.inputs(&design.model, &inputs, &lead.start);
        Ok(Self {
            start: lead.start.motion(),
            drives: task.drive_laws(&design.drive_offsets, &there.drives.value)?,
            lead: Some(lead),
            out_of_reach: None,
        })
    }

    fn at_design<L: Suspension<N>>(design: &Design<L, N>) -> Self {
        Self {
            start: Motion::at_rest(design.q),
            drives: DriveLaws::held(design.drives.values()),
            lead: None,
            out_of_reach: None,
        }
    }
}

/// The failure that something is out of reach, followed by what may be mistaken.
fn doubted(unreached: Failure, doubt: &String) -> Failure {
    match unreached {
        Failure::Solver(text) => Failure::Solver(format!("{text}\n{doubt}")),
        other => other,
    }
}
