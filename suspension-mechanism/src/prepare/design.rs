//! The design position, at which the mechanism is assembled and its markers are attached.

pub(super) mod collinear_body;
pub(super) mod outlier;
pub(super) mod unsatisfied;

use std::f64::consts::PI;

use nalgebra::{SVector, Vector3};
use suspension_core::directions::Directions;
use suspension_core::listing::{DriveKind, Kind};
use suspension_core::solve::motion::Prescribed;
use suspension_core::{Linkage, Newton, Signal, Values, assemble};

use crate::failure::Failure;
use crate::file::{Offset, Position};
use crate::mechanism::{Suspension, inputs_at_rest, unit_change};
use crate::number::rounded;
use crate::prepare::design::unsatisfied::Unsatisfied;
use crate::prepare::task::Task;

/// The configuration in which markers are attached.
pub(super) struct Design<L: Linkage<N>, const N: usize> {
    pub(super) model: L,
    /// The offsets to be added to drives to get the file's coordinates.
    pub(super) drive_offsets: L::Drives,
    pub(super) q: SVector<f64, N>,
    pub(super) drives: L::Drives,
    /// All points in this configuration.
    pub(super) points: L::Points,
    /// The equation that the file's points do not satisfy, if any.
    pub(super) off: Option<Unsatisfied>,
}

impl<L: Suspension<N>, const N: usize> Design<L, N> {
    /// The drives' values in the file's coordinates, from local ones.
    pub(super) fn drives_in_file(&self, local: &L::Drives) -> Vec<f64> {
        drives_in_file(&self.model, &self.drive_offsets, local)
    }

    /// The derivatives of the points with respect to a drive; `None` if the mechanism locks.
    pub(super) fn per(&self, drive: usize) -> Option<Vec<Vector3<f64>>> {
        let moved = Directions::at(&self.model, self.drives, &self.q, |directions| {
            directions.points(unit_change(drive))
        });
        Some(moved.ok()?.rate.values().collect())
    }

    /// The measures of the linkage, in local coordinates.
    pub(super) fn measures(&self) -> L::Measures {
        let still = L::Points::from_values([]);
        let design = Signal {
            value: self.points,
            rate: still,
            second_rate: still,
        };
        self.model.measures(&design).value
    }
}

pub(super) fn at_design<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    model: L,
    guess: &L::Points,
) -> Result<Design<L, N>, Failure> {
    let Task { file, names, .. } = task;
    let drive_offsets = task.origin.of_drives(&model);
    let drives = match &file.design {
        Some(table) => {
            let each = names.drives.iter().zip(drive_offsets.values());
            let drives = L::Drives::from_values(each.map(|(drive, offset)| {
                let stated = *table.get_ref()[drive.name.as_str()].get_ref();
                task.in_radians(stated, drive.kind) - offset
            }));
            task.check_angles(drives.values(), table)?;
            task.check_lengths(drives.values(), table)?;
            drives
        }
        None => model.drives_at(guess),
    };
    let inputs = inputs_at_rest(drives);
    let mut q = model.unknowns(guess);
    let fixed = Prescribed::new(&model, &inputs).fixed.value;
    let off = unsatisfied(task, &model, guess);
    if off.is_some() || file.lengths.is_some() || file.design.is_some() {
        assemble(&Newton::from_afar(), &model, &inputs, &mut q).map_err(|error| {
            let drives = drives_in_file(&model, &drive_offsets, &drives);
            let at = names.drives_in_words(&drives, file.unit(), None);
            let of_points = model.drives_at(guess);
            let turned = describe_other_turn(task, drives.into_iter().zip(of_points.values()));
            unassembled(task, &at, &names.cause(&error), (off, turned))
        })?;
    }
    check_nearness(task, off, model.size())?;
    let points = place_markers(task, &model.points(&q, &fixed));
    check_spin_axis(task, &points)?;
    let model = model
        .with_markers(&points)
        .map_err(|error| task.refuse_geometry(&error))?;
    Ok(Design {
        model,
        drive_offsets,
        q,
        drives,
        points,
        off,
    })
}

/// The equation that the points do not satisfy; `None` if lengths make the points a guess.
fn unsatisfied<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    model: &L,
    points: &L::Points,
) -> Option<Unsatisfied> {
    if task.file.lengths.is_some() {
        return None;
    }
    let inputs = inputs_at_rest(model.drives_at(points));
    let Prescribed { fixed, drives } = Prescribed::new(model, &inputs);
    let residual = model.residual(&model.unknowns(points), &fixed.value, &drives.value);
    Unsatisfied::find(&residual, model.size())
}

/// The fraction of the mechanism's size above which a misfit is a mistake, and not rounding.
const MISTAKE: f64 = 0.1;

/// Refuses points from which a mechanism other than the stated one would be assembled.
fn check_nearness(task: &Task<'_>, off: Option<Unsatisfied>, size: f64) -> Result<(), Failure> {
    let Some(off) = off.filter(|off| off.by > MISTAKE * size) else {
        return Ok(());
    };
    let message = format!(
        "the points do not satisfy {}, more than a tenth of the suspension's size; correct a point of the statement \
         that has this equation, or the statement",
        task.unsatisfied_in_words(off)
    );
    Err(task
        .source
        .refuse(&task.place_of_equation(off.equation), message))
}

/// The failure to assemble: the equation at which a solver ends tells little about the number that was mistyped.
fn unassembled(
    task: &Task<'_>,
    at: &str,
    cause: &str,
    (off, turned): (Option<Unsatisfied>, Option<String>),
) -> Failure {
    let Task { source, file, .. } = task;
    let name = source.name();
    let doubt = match off {
        _ if file.lengths.is_some() => {
            "lengths and points may not fit together: is one of them in another unit?".to_owned()
        }
        Some(off) if file.design.is_none() => {
            let off = task.unsatisfied_in_words(off);
            return Failure::Solver(format!(
                "{name}: the points do not fit together: they do not satisfy {off}, and there is no configuration near by \
                 at {at} ({cause}); move one of the points of that statement"
            ));
        }
        _ => turned.unwrap_or_else(|| "the design may be out of reach".to_owned()),
    };
    Failure::Solver(format!(
        "{name}: the points do not assemble at {at}: {cause}; {doubt}"
    ))
}

/// A sentence about the first angle about an axis that `[design]` states more than half a turn from the points'
/// value, if there is one. `stated` has the stated value and that of the points for each drive.
fn describe_other_turn(
    task: &Task<'_>,
    stated: impl Iterator<Item = (f64, f64)>,
) -> Option<String> {
    let Task { file, names, .. } = task;
    let mut drives = names.drives.iter().zip(stated);
    let (drive, (_, at)) = drives
        .find(|(drive, (stated, at))| drive.kind == DriveKind::Turn && (stated - at).abs() > PI)?;
    let (name, unit) = (&drive.name, file.angle.symbol());
    let at = rounded(at * file.angle.radian(), 6);
    Some(format!(
        "`{name}` is {at} {unit} at the points, and [design] must state a value less than half a turn from it"
    ))
}

/// Places markers where the file wants them in the configuration `points`. A marker with an offset is placed there;
/// one with coordinates is attached to its body at the file's points.
fn place_markers<P: Values<Vector3<f64>>>(task: &Task<'_>, points: &P) -> P {
    let Task { file, names, .. } = task;
    let placed: Vec<Vector3<f64>> = points.values().collect();
    let position = |wanted: &str| {
        let found = names.point(wanted);
        found.map_or_else(Vector3::zeros, |point| placed[point])
    };
    let each = names.points.iter().enumerate();
    P::from_values(each.map(
        |(point, name)| match file.points.get_ref()[name.as_str()].get_ref() {
            Position::Off(Offset { from, offset }) => {
                position(from.get_ref()) + Vector3::from(*offset.get_ref())
            }
            Position::At(_) => placed[point],
        },
    ))
}

/// The length, in metres, below which the direction of a spin axis is rounding.
const SHORTEST: f64 = 1e-6;

/// Checks that each spin axis has a direction.
fn check_spin_axis<P: Values<Vector3<f64>>>(task: &Task<'_>, points: &P) -> Result<(), Failure> {
    let Task { file, names, .. } = task;
    let placed: Vec<Vector3<f64>> = points.values().collect();
    for wheel in &names.wheels {
        let [inner, centre] = wheel.points.axis;
        let length = (placed[centre] - placed[inner]).norm();
        if length > SHORTEST * file.unit().metre() && length.is_finite() {
            continue;
        }
        let name = &names.points[centre];
        let place = file.points.get_ref()[name.as_str()].span();
        let message = format!(
            "both points of the spin axis are in the same place; put `{name}` outboard of the other one"
        );
        return Err(task.source.refuse(&place, message));
    }
    Ok(())
}

/// The drives' values in the file's coordinates, from local ones.
fn drives_in_file<L: Suspension<N>, const N: usize>(
    model: &L,
    offsets: &L::Drives,
    local: &L::Drives,
) -> Vec<f64> {
    let each = local.values().zip(offsets.values());
    let each = each.take(model.count(Kind::Drive));
    each.map(|(local, offset)| local + offset).collect()
}
