//! From the contents of a file to a mechanism at its design position.

use nalgebra::Vector3;
use suspension_core::listing::Parts;
use suspension_core::model::local::LocalOrigin;
use suspension_core::{GeometryError, Values, model::parts};
use suspension_runtime::Listing;

use crate::failure::Failure;
use crate::file::{LeadingMeasure, MotionFile, Source, check, leading_measure};
use crate::mechanism::{Names, Suspension};
use crate::prepare::design::collinear_body;
use crate::prepare::design::outlier::Outlier;
use crate::prepare::design::{Design, at_design};
use crate::prepare::listing::points::stated_at;
use crate::prepare::task::{Request, Task};
use crate::prepare::vehicle::names_with_vehicle;

/// A mechanism at its design position, and the file that it comes from.
pub(super) struct Assembled<'a, L: Suspension<N>, const N: usize> {
    pub(super) task: Task<'a>,
    /// The points as the file has them, in local coordinates.
    pub(super) given: L::Points,
    pub(super) design: Design<L, N>,
    /// The measure that leads instead of a drive.
    pub(super) leading_measure: Option<LeadingMeasure>,
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
    pub(super) fn new(request: &Request<'a>, listing: L::Listing) -> Result<Self, Failure> {
        let names = names(request, &listing);
        let leading_measure = check_names(request, &names)?;
        let stated = stated_points(request.file, &names);
        let origin = LocalOrigin::among(stated.iter().copied());
        let mut task = Task::new(request, names, origin);
        parts::finite(stated.iter().copied()).map_err(|error| task.refuse_geometry(&error))?;
        let outlier = Outlier::find(&task, &stated);
        let outlier_first = |failure| prepend_outlier(outlier.as_ref(), failure, request.source);
        let local = stated.iter().map(|point| point - origin.position());
        let local: Vec<_> = local.collect();
        let given = L::Points::from_values(local.iter().copied());
        let model: L = model(&task, (listing, request.listing), &given).map_err(outlier_first)?;
        task.names = names_with_vehicle(&task, &local)?;
        let design = at_design(&task, model, &given).map_err(outlier_first)?;
        Ok(Self {
            task,
            given,
            design,
            leading_measure,
            outlier,
        })
    }

    /// All points, in the file's coordinates.
    pub(super) fn points_in_file(&self) -> Vec<Vector3<f64>> {
        let origin = self.task.origin.position();
        let points = self
            .design
            .points
            .values()
            .take(self.task.names.points.len());
        points.map(|point| point + origin).collect()
    }

    pub(super) fn measured(&self) -> Measured {
        let design = &self.design;
        let count = self.task.names.measures.len();
        let of_listing = |all: L::Measures| all.values().take(count).collect();
        let offsets: Vec<f64> = of_listing(self.task.origin.of_measures(&design.model));
        let local: Vec<f64> = of_listing(design.measures());
        let measured = local.iter().zip(&offsets);
        Measured {
            in_file: measured.map(|(local, offset)| local + offset).collect(),
            offsets,
        }
    }

    /// A failure, preceded by the point that lies far from all others, of which it may be a consequence.
    pub(super) fn outlier_first(&self, failure: Failure) -> Failure {
        prepend_outlier(self.outlier.as_ref(), failure, self.task.source)
    }
}

fn prepend_outlier(outlier: Option<&Outlier>, failure: Failure, source: &Source) -> Failure {
    match outlier {
        Some(outlier) => outlier.prepend_to(failure, source),
        None => failure,
    }
}

/// The names of all parts, with the parts of a listing that was read at run time.
fn names(request: &Request<'_>, listing: &impl Parts) -> Names {
    let names = Names::new(listing);
    match request.listing {
        Some(statements) => names.with_parts_of(statements),
        None => names,
    }
}

fn check_names(request: &Request<'_>, names: &Names) -> Result<Option<LeadingMeasure>, Failure> {
    let Request {
        source,
        file,
        listing,
        ..
    } = *request;
    let unjoined = listing.map(Listing::unjoined_points);
    let drives = names.drive_names();
    let mut checks = vec![
        check::point_names(source, file, &names.points),
        check::points(source, file, names.markers(), &unjoined.unwrap_or_default()),
    ];
    if let Some(lengths) = &file.lengths {
        checks.push(check::names(source, lengths, "length", &names.lengths));
        checks.push(check::lengths(source, lengths));
    }
    if let Some(design) = &file.design {
        checks.push(check::names(source, design, "drive", &drives));
        checks.push(check::finite_values(source, design, "drive"));
    }
    checks.push(check::drives(source, &file.drives));
    let leading = leading_measure(source, &file.drives, &drives, &names.measure_names());
    let (_, leading) = Failure::both(Failure::all(checks), leading)?;
    Ok(leading)
}

/// The points as the file has them; relative ones are placed off the others as given.
fn stated_points(file: &MotionFile, names: &Names) -> Vec<Vector3<f64>> {
    let each = names.points.iter();
    each.map(|name| stated_at(&file.points, name)).collect()
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
        let flat = collinear_body::refused(task, statements, &placed, &error);
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
