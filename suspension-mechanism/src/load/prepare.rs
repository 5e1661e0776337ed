//! From what a file says to a mechanism in the configuration of the first instant.

use nalgebra::Vector3;
use suspension_core::local::LocalOrigin;
use suspension_core::{GeometryError, Motion, Values, parts};
use suspension_runtime::Listing;

use crate::failure::Failure;
use crate::file::{MotionFile, Offset, Position, Source, StandIn, check, stand_in};
use crate::load::design::at_design;
use crate::load::masses::masses;
use crate::load::notes::{loose_markers, notes, short_of_stop};
use crate::load::outlier::Outlier;
use crate::load::sharing::sharing;
use crate::load::springs::springs;
use crate::load::task::Task;
use crate::load::vehicle::with_vehicle;
use crate::load::{columns, led, said_of_drives, said_of_wheels, start};
use crate::mechanism::{Description, DriveLaws, Instants, Mechanism, Names, Suspension};

/// What is to be prepared.
#[derive(Clone, Copy)]
pub(super) struct Request<'a> {
    pub(super) source: &'a Source,
    pub(super) file: &'a MotionFile,
    /// Its listing, where that was read while the program runs.
    pub(super) listing: Option<&'a Listing>,
    pub(super) instants: &'a Instants,
    pub(super) to: Start,
}

/// Where a mechanism is when work on it starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Start {
    /// At the first instant of its motion.
    FirstInstant,
    /// There; where that is out of reach at the design position, with a note.
    WithinReach,
    /// At the design position, where drives, not a measure, hold it.
    Design,
}

/// The mechanism of a file, of a listing.
pub(super) fn prepare<L: Suspension<N>, const N: usize>(
    request: Request<'_>,
    linkage: &str,
    listing: L::Listing,
) -> Result<Mechanism<L, N>, Failure> {
    let Request {
        source,
        file,
        listing: statements,
        instants,
        to,
    } = request;
    let names = Names::of(&listing);
    let names = match statements {
        Some(statements) => names.with_links_of(statements),
        None => names,
    };
    let task = Task {
        source,
        file,
        first: instants.ends()[0],
        names: &names,
        middle: 0.0,
    };
    let stand_in = check_names(&task)?;
    let file = file.clone().in_radians(names.angles());
    let task = Task {
        file: &file,
        ..task
    };
    let given: L::Points = guess(&task);
    parts::finite(given.values().take(names.points.len()))
        .map_err(|error| task.refuse_geometry(&error))?;
    let outlier = Outlier::among(&task, &given);
    let outlier_first = |failure| match &outlier {
        Some(outlier) => outlier.before(failure, source),
        None => failure,
    };
    let origin = LocalOrigin::among(given.values().take(names.points.len()));
    let file = file.seen_from(origin.position().into());
    let task = Task {
        file: &file,
        middle: origin.position().y,
        ..task
    };
    let guess = guess(&task);
    let model = L::of(listing, &guess).and_then(|model| with_lengths(&task, model));
    let model = model.map_err(|error| outlier_first(task.refuse_geometry(&error)))?;
    let names = with_vehicle(&task)?;
    let task = Task {
        names: &names,
        ..task
    };
    let offsets = origin.of_drives(&model);
    let file = file
        .clone()
        .driven_from(names.of_drives().into_iter().zip(offsets.values()));
    let task = Task {
        file: &file,
        ..task
    };
    let design = at_design(&task, model, origin, &guess).map_err(outlier_first)?;
    let of_listing = |all: L::Measures| all.values().take(names.measures.len()).collect();
    let measure_offsets: Vec<f64> = of_listing(origin.of_measures(&design.model));
    let measures: Vec<f64> = of_listing(design.measures());
    let measures = measures.iter().zip(&measure_offsets);
    let design_measures: Vec<f64> = measures.map(|(local, offset)| local + offset).collect();
    let springs = springs(&task, &design_measures)?;
    let points: Vec<_> = design.points.values().take(names.points.len()).collect();
    let masses = match statements {
        Some(statements) => {
            let in_file = points.iter().map(|point| point + origin.position());
            let in_file: Vec<_> = in_file.collect();
            masses(&task, statements, (origin.position(), &in_file))?
        }
        None => Vec::new(),
    };
    let mut notes = notes(&task, &guess, &design.points, design.off, outlier.as_ref());
    if let Some(statements) = statements {
        notes.extend(loose_markers(&task, &design, statements));
    }
    let sharing = sharing(&names, &design);
    notes.extend(said_of_wheels::notes(&task, &design, &sharing));
    if to != Start::Design {
        notes.extend(short_of_stop(&task, instants));
    }
    let drives = task.drive_laws(design.drives.values());
    let doubts = match outlier {
        None => said_of_drives::doubts(&task, &design, &drives, instants),
        Some(_) => Vec::new(),
    };
    notes.extend(doubts.iter().cloned());
    let first = drives.inputs::<L::Drives>(task.first).drives.value;
    task.check_angles(first.values(), &file.drives)?;
    let at_design = || {
        let drives = DriveLaws::held(design.drives.values());
        (Motion::at_rest(design.q), drives, None)
    };
    let (start, drives, lead) = match stand_in {
        _ if to == Start::Design => at_design(),
        None => match start::to_first_instant(&task, &design, &drives) {
            Ok(start) => (start, drives, None),
            Err(unreached) if to == Start::WithinReach => {
                notes.push(format!("{unreached}; it stays at the design position"));
                at_design()
            }
            Err(unreached) => {
                let unreached = doubts.iter().fold(unreached, doubted);
                return Err(outlier_first(unreached));
            }
        },
        Some(stand_in) => {
            let lead =
                led::to_first_instant(&task, &design, &drives, &stand_in).map_err(outlier_first)?;
            let there = lead.inputs(&design.model, &drives.inputs(task.first), &lead.start);
            let drives = task.drive_laws(there.drives.value.values());
            (lead.start.motion(), drives, Some(lead))
        }
    };
    let drive_offsets = offsets.values().take(names.drives.len());
    let named = names.clone().with(springs, masses).designed(&points);
    let named = named.sharing(&sharing);
    columns::check(source, &named, file.unit())?;
    let description = Description {
        linkage: linkage.to_owned(),
        unit: file.unit(),
        axes: file.axes,
        origin: origin.position(),
        instants: instants.clone(),
        drives,
        drive_offsets: drive_offsets.collect(),
        measure_offsets,
        design: design.given(&design.drives),
        design_measures,
        led_by: lead.as_ref().map(|lead| lead.measure),
        names: named,
        notes,
    };
    Ok(Mechanism {
        description,
        model: design.model,
        start,
        lead,
        changing: None,
    })
}

/// What is out of reach, and below it what may be mistaken.
fn doubted(unreached: Failure, doubt: &String) -> Failure {
    match unreached {
        Failure::Solver(text) => Failure::Solver(format!("{text}\n{doubt}")),
        other => other,
    }
}

fn check_names(task: &Task<'_>) -> Result<Option<StandIn>, Failure> {
    let Task {
        source,
        file,
        names,
        ..
    } = task;
    check::point_names(source, file, &names.points)?;
    check::points(source, file, names.markers())?;
    if let Some(lengths) = &file.lengths {
        check::names(source, lengths, "length", &names.lengths)?;
        check::lengths(source, lengths)?;
    }
    let drives = names.of_drives();
    if let Some(design) = &file.design {
        check::names(source, design, "drive", &drives)?;
        check::finite_values(source, design, "drive")?;
    }
    let stand_in = stand_in(source, &file.drives, &drives, &names.of_measures())?;
    check::drives(source, &file.drives)?;
    Ok(stand_in)
}

/// The points as the file has them, relative ones off the others as they stand.
fn guess<P: Values<Vector3<f64>>>(task: &Task<'_>) -> P {
    let points = task.file.points.get_ref();
    let each = task
        .names
        .points
        .iter()
        .map(|name| match points[name.as_str()].get_ref() {
            Position::At(at) => Vector3::from(*at),
            Position::Off(Offset { from, offset }) => {
                let base = match points[from.get_ref().as_str()].get_ref() {
                    Position::At(at) => *at,
                    Position::Off(_) => [f64::NAN; 3],
                };
                Vector3::from(base) + Vector3::from(*offset)
            }
        });
    P::from_values(each)
}

/// The model with the lengths that the file states.
fn with_lengths<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    model: L,
) -> Result<L, GeometryError> {
    let Some(table) = &task.file.lengths else {
        return Ok(model);
    };
    let table = table.get_ref();
    let lengths = task.names.lengths.iter();
    let lengths = lengths.map(|name| *table[name.as_str()].get_ref());
    model.with_lengths(&L::Lengths::from_values(lengths))
}
