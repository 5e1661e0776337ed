//! From a motion file to a mechanism in the configuration of the first instant.

mod catalogue;
mod led;
mod start;

use nalgebra::{SVector, Vector3};
use suspension_core::wheel::Wheel;
use suspension_core::{
    GeometryError, HasWheel, Linkage, LocalOrigin, Named, Newton, Parts, Values, assemble, parts,
};
use toml::Spanned;

use crate::failure::Failure;
use crate::input::check;
use crate::input::drives::{self, DriveLaws, check_angles, in_words};
use crate::input::file::{MotionFile, Offset, Position};
use crate::input::leading::{StandIn, stand_in};
use crate::input::polynomial::Polynomial;
use crate::input::source::Source;
use crate::study::columns::PointNames;
use crate::study::{Assembled, Suspension, cause};

pub use catalogue::{Loaded, load, load_driven, load_own};

/// A file that is being prepared.
struct Task<'a> {
    source: &'a Source,
    file: &'a MotionFile,
    linkage: &'static str,
    first: f64,
}

fn prepare<L: Suspension<N>, const N: usize>(task: &Task<'_>) -> Result<Assembled<L, N>, Failure> {
    let stand_in = check_names::<L, N>(task)?;
    let given = guess::<L, N>(task);
    parts::finite(given.values()).map_err(|error| refuse_geometry::<L, N>(task, &error))?;
    let origin = LocalOrigin::among(given.values());
    let file = task.file.seen_from(origin.position().into());
    let guess = guess::<L, N>(&Task {
        file: &file,
        ..*task
    });
    let model = model::<L, N>(task, &guess)?;
    let offsets = origin.of_drives(&model);
    let names = <L::Drives as Named<f64>>::NAMES.iter().copied();
    let file = file.driven_from(names.zip(offsets.values()));
    let task = &Task {
        file: &file,
        ..*task
    };
    let design = at_design::<L, N>(task, model, origin, &guess)?;
    let drives = drive_laws::<L, N>(task, &design.drives);
    let first = drives.inputs::<L::Drives>(task.first).drives.value;
    check_angles::<L, _, N>(task.source, &first, &task.file.drives)?;
    let (start, drives, lead) = match stand_in {
        None => (
            start::to_first_instant(task, &design, &drives)?,
            drives,
            None,
        ),
        Some(stand_in) => {
            let lead = led::to_first_instant(task, &design, &drives, stand_in)?;
            let there = lead.inputs(&design.model, &drives.inputs(task.first), &lead.start);
            let drives = drive_laws::<L, N>(task, &there.drives.value);
            (lead.start.motion(), drives, Some(lead))
        }
    };
    Ok(Assembled {
        linkage: task.linkage,
        unit: task.file.unit,
        origin,
        model: design.model,
        first: task.first,
        start,
        drives,
        lead,
    })
}

fn check_names<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
) -> Result<Option<StandIn>, Failure> {
    let Task { source, file, .. } = task;
    let drives = <L::Drives as Named<f64>>::NAMES;
    let points = <L::Points as Named<Vector3<f64>>>::NAMES;
    check::names(source, &file.points, "point", points)?;
    check::points(source, file, &PointNames::of::<L, N>().markers)?;
    if let Some(lengths) = &file.lengths {
        check::names(source, lengths, "length", L::Lengths::NAMES)?;
        check::lengths(source, lengths)?;
    }
    if let Some(design) = &file.design {
        check::names(source, design, "drive", drives)?;
        check::finite_values(source, design, "drive")?;
    }
    let measures = <L::Measures as Named<f64>>::NAMES;
    let stand_in = stand_in(source, &file.drives, drives, measures)?;
    check::drives(source, &file.drives)?;
    Ok(stand_in)
}

/// The points as the file has them, relative ones off the others as they stand.
fn guess<L: Suspension<N>, const N: usize>(task: &Task<'_>) -> L::Points {
    let points = task.file.points.get_ref();
    L::Points::from_fn(|name| match points[name].get_ref() {
        Position::At(at) => Vector3::from(*at),
        Position::Off(Offset { from, offset }) => {
            let base = match points[from.get_ref().as_str()].get_ref() {
                Position::At(at) => *at,
                Position::Off(_) => [f64::NAN; 3],
            };
            Vector3::from(base) + Vector3::from(*offset)
        }
    })
}

fn model<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    guess: &L::Points,
) -> Result<L, Failure> {
    let model = L::new(guess).map_err(|error| refuse_geometry::<L, N>(task, &error))?;
    match &task.file.lengths {
        None => Ok(model),
        Some(lengths) => {
            let table = lengths.get_ref();
            let lengths = L::Lengths::from_fn(|name| *table[name].get_ref());
            model
                .with_lengths(&lengths)
                .map_err(|error| refuse_geometry::<L, N>(task, &error))
        }
    }
}

/// Points out, in the file, what makes a linkage impossible to build.
fn refuse_geometry<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    error: &GeometryError,
) -> Failure {
    let Task { source, file, .. } = task;
    let points = file.points.get_ref();
    let lengths = file.lengths.as_ref();
    let listing = L::Listing::default();
    let name = listing.name(error.part());
    let span = match error {
        GeometryError::NotFinite { .. }
        | GeometryError::Collinear { .. }
        | GeometryError::Flat { .. }
        | GeometryError::NoLine { .. } => points.get(name).map(Spanned::span),
        GeometryError::BadLength { .. } => lengths
            .and_then(|lengths| lengths.get_ref().get(name))
            .map(Spanned::span),
        GeometryError::NotClosed { .. } => lengths.map(Spanned::span),
    };
    source.refuse(
        &span.unwrap_or_else(|| file.points.span()),
        error.named(&listing),
    )
}

/// The configuration in which markers are attached.
struct Design<L: Linkage<N>, const N: usize> {
    origin: LocalOrigin<f64>,
    model: L,
    q: SVector<f64, N>,
    drives: L::Drives,
}

fn at_design<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    model: L,
    origin: LocalOrigin<f64>,
    guess: &L::Points,
) -> Result<Design<L, N>, Failure> {
    let Task { source, file, .. } = task;
    let design = match &file.design {
        Some(values) => {
            let design = L::Drives::from_fn(|name| *values.get_ref()[name].get_ref());
            check_angles::<L, _, N>(source, &design, values)?;
            design
        }
        None => model.drives_at(guess),
    };
    let at_rest = DriveLaws::new(design.values().map(|value| Polynomial::new(vec![value])));
    let inputs = at_rest.inputs::<L::Drives>(0.0);
    let mut q = model.unknowns(guess);
    if file.lengths.is_some() || file.design.is_some() {
        assemble(&Newton::from_afar(), &model, &inputs, &mut q).map_err(|error| {
            let at = in_words::<L, N>(&drives::given(&origin, &model, &design), file.unit);
            unassembled(task, &at, &cause::<L, N>(&error, file.unit))
        })?;
    }
    let fixed = model.drive_anchors(*model.fixed(), &model.coordinates(&inputs.drives).value);
    let points = place_markers::<L, N>(task, &model.points(&q, &fixed));
    let model = model
        .with_markers(&points)
        .map_err(|error| refuse_geometry::<L, N>(task, &error))?;
    match Wheel::of(points.wheel()) {
        Some(_) => Ok(Design {
            origin,
            model,
            q,
            drives: design,
        }),
        None => {
            let centre = PointNames::of::<L, N>().wheel_centre;
            let span = file.points.get_ref()[centre].span();
            Err(source.refuse(
                &span,
                format!("point `{centre}` gives the spin axis no length"),
            ))
        }
    }
}

/// The equation that a solver ends at says little about the number that was mistyped.
fn unassembled(task: &Task<'_>, at: &str, cause: &str) -> Failure {
    let doubt = if task.file.lengths.is_some() {
        "lengths and points may not fit together: is one of them in another unit?"
    } else {
        "the design may be out of reach"
    };
    let name = task.source.name();
    Failure::Solver(format!(
        "{name}: the points do not assemble at {at}: {cause}; {doubt}"
    ))
}

/// Puts markers where the file wants them in the configuration `points`. Where the points of the
/// file are exact, a marker with coordinates is already attached to them.
fn place_markers<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    points: &L::Points,
) -> L::Points {
    let names = <L::Points as Named<Vector3<f64>>>::NAMES;
    let markers = PointNames::of::<L, N>().markers;
    let position = |name: &str| {
        let found = names.iter().zip(points.values()).find(|(n, _)| **n == name);
        found.map_or_else(Vector3::zeros, |(_, position)| position)
    };
    L::Points::from_fn(|name| match task.file.points.get_ref()[name].get_ref() {
        Position::Off(Offset { from, offset }) => position(from.get_ref()) + Vector3::from(*offset),
        Position::At(at) if task.file.lengths.is_some() && markers.contains(&name) => {
            Vector3::from(*at)
        }
        Position::At(_) => position(name),
    })
}

/// The drives over time; those that the file does not lead stay as they are in `held`.
fn drive_laws<L: Suspension<N>, const N: usize>(task: &Task<'_>, held: &L::Drives) -> DriveLaws {
    let table = task.file.drives.get_ref();
    let each = <L::Drives as Named<f64>>::NAMES.iter().zip(held.values());
    DriveLaws::new(each.map(|(name, held)| {
        let stated = table.get(*name).map(|law| law.get_ref().clone());
        Polynomial::new(stated.unwrap_or_else(|| vec![held]))
    }))
}
