//! From the contents of a file to a mechanism at its design position.

use nalgebra::Vector3;
use suspension_core::listing::Parts;
use suspension_core::model::local::LocalOrigin;
use suspension_core::{GeometryError, Values, model::parts};
use suspension_runtime::Listing;

use crate::failure::Failure;
use crate::file::{MotionFile, Offset, Position, Source, StandIn, check, stand_in};
use crate::load::design::{Design, at_design};
use crate::load::flat_body;
use crate::load::outlier::Outlier;
use crate::load::request::Request;
use crate::load::task::Task;
use crate::load::vehicle::with_vehicle;
use crate::mechanism::{Names, Suspension};

/// A mechanism at its design position, and the file that it comes from.
pub(super) struct Assembled<'a, L: Suspension<N>, const N: usize> {
    source: &'a Source,
    /// The file in local coordinates, angles in radians.
    file: MotionFile,
    names: Names,
    first: f64,
    /// The points as the file has them.
    pub(super) given: L::Points,
    pub(super) design: Design<L, N>,
    /// The offsets to be added to drives to get the file's coordinates.
    pub(super) drive_offsets: L::Drives,
    /// The measure that leads instead of a drive.
    pub(super) stand_in: Option<StandIn>,
    pub(super) outlier: Option<Outlier>,
}

/// The measures at the design position.
pub(super) struct Measured {
    /// The measures in the file's coordinates.
    pub(super) in_file: Vec<f64>,
    /// The differences of these from the measures in local coordinates.
    pub(super) offsets: Vec<f64>,
}

impl<'a, L: Suspension<N>, const N: usize> Assembled<'a, L, N> {
    /// The mechanism of a file, and of a listing.
    pub(super) fn of(request: &Request<'a>, listing: L::Listing) -> Result<Self, Failure> {
        let names = names(request, &listing);
        let task = Task {
            source: request.source,
            file: request.file,
            first: request.instants.ends()[0],
            names: &names,
            middle: 0.0,
        };
        let stand_in = check_names(&task, request.listing)?;
        let file = request.file.clone().in_radians(names.angles());
        let task = Task {
            file: &file,
            ..task
        };
        let points: L::Points = given(&task);
        let placed = || points.values().take(names.points.len());
        parts::finite(placed()).map_err(|error| task.refuse_geometry(&error))?;
        let outlier = Outlier::among(&task, &points);
        let outlier_first = |failure| before(outlier.as_ref(), failure, request.source);
        let origin = LocalOrigin::among(placed());
        let file = file.seen_from(origin.position().into());
        let task = Task {
            file: &file,
            middle: origin.position().y,
            ..task
        };
        let given = given(&task);
        let model: L = model(&task, (listing, request.listing), &given).map_err(outlier_first)?;
        let placed: Vec<_> = given.values().take(names.points.len()).collect();
        let designed = names.clone().designed(&placed);
        let names = with_vehicle(&Task {
            names: &designed,
            ..task
        })?;
        let drive_offsets = origin.of_drives(&model);
        let offsets = names.of_drives().into_iter().zip(drive_offsets.values());
        let file = file.clone().driven_from(offsets);
        let task = Task {
            file: &file,
            names: &names,
            ..task
        };
        let design = at_design(&task, model, origin, &given).map_err(outlier_first)?;
        Ok(Self {
            source: request.source,
            first: task.first,
            given,
            design,
            drive_offsets,
            stand_in,
            outlier,
            file,
            names,
        })
    }

    pub(super) fn task(&self) -> Task<'_> {
        Task {
            source: self.source,
            file: &self.file,
            first: self.first,
            names: &self.names,
            middle: self.design.origin.position().y,
        }
    }

    /// All points, in the file's coordinates.
    pub(super) fn in_file(&self) -> Vec<Vector3<f64>> {
        let origin = self.design.origin.position();
        let points = self.design.points.values().take(self.names.points.len());
        points.map(|point| point + origin).collect()
    }

    pub(super) fn measured(&self) -> Measured {
        let design = &self.design;
        let of_listing = |all: L::Measures| all.values().take(self.names.measures.len()).collect();
        let offsets: Vec<f64> = of_listing(design.origin.of_measures(&design.model));
        let local: Vec<f64> = of_listing(design.measures());
        let measured = local.iter().zip(&offsets);
        Measured {
            in_file: measured.map(|(local, offset)| local + offset).collect(),
            offsets,
        }
    }

    /// A failure, preceded by the point that lies far from all others, of which it may be a consequence.
    pub(super) fn outlier_first(&self, failure: Failure) -> Failure {
        before(self.outlier.as_ref(), failure, self.source)
    }
}

fn before(outlier: Option<&Outlier>, failure: Failure, source: &Source) -> Failure {
    match outlier {
        Some(outlier) => outlier.before(failure, source),
        None => failure,
    }
}

/// The names of all parts, with the parts of a listing that was read at run time.
fn names(request: &Request<'_>, listing: &impl Parts) -> Names {
    let names = Names::of(listing);
    match request.listing {
        Some(statements) => names.with_parts_of(statements),
        None => names,
    }
}

fn check_names(task: &Task<'_>, listing: Option<&Listing>) -> Result<Option<StandIn>, Failure> {
    let Task {
        source,
        file,
        names,
        ..
    } = task;
    check::point_names(source, file, &names.points)?;
    let unjoined = listing.map(Listing::unjoined_points);
    check::points(source, file, names.markers(), &unjoined.unwrap_or_default())?;
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

/// The points as the file has them; relative ones are placed off the others as given.
fn given<P: Values<Vector3<f64>>>(task: &Task<'_>) -> P {
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

/// The model of a listing at points, with the lengths that the file states.
fn model<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    (listing, statements): (L::Listing, Option<&Listing>),
    given: &L::Points,
) -> Result<L, Failure> {
    let model = L::of(listing, given).and_then(|model| with_lengths(task, model));
    model.map_err(|error| {
        let placed: Vec<_> = given.values().take(task.names.points.len()).collect();
        let flat = flat_body::refused(task, statements, &placed, &error);
        flat.unwrap_or_else(|| task.refuse_geometry(&error))
    })
}

/// A model with the lengths that the file states, if it states any.
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
