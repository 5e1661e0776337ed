//! The masses of a motion file, with its names replaced by indices.

use nalgebra::{Matrix3, Vector3};
use suspension_core::inertia::RigidBody;
use suspension_listing::Kind;
use suspension_listing::did_you_mean::unknown;
use suspension_runtime::{Listing, Statement};
use toml::Spanned;

use crate::failure::Failure;
use crate::file::{BodyMass, Centre, MassTable};
use crate::mechanism::Mass;
use crate::prepare::task::Task;

/// The masses of a file. `design` are its points at the design position, in the file's coordinates, and `origin` is
/// the offset of local coordinates from them.
///
/// # Errors
///
/// [`Failure::Input`] at a name that is not a part of the mechanism, and at a number that is not a mass or an
/// inertia.
pub(crate) fn masses(
    task: &Task<'_>,
    listing: &Listing,
    (origin, design): (Vector3<f64>, &[Vector3<f64>]),
) -> Result<Vec<Mass>, Failure> {
    let Some(table) = &task.file.masses else {
        return Ok(Vec::new());
    };
    let reader = Reader {
        task,
        listing,
        origin,
        design,
    };
    let each = table.get_ref().iter();
    Failure::all(each.map(|(name, mass)| reader.read_mass(name, mass)))
}

struct Reader<'a> {
    task: &'a Task<'a>,
    listing: &'a Listing,
    origin: Vector3<f64>,
    design: &'a [Vector3<f64>],
}

impl Reader<'_> {
    fn read_mass(
        &self,
        name: &Spanned<String>,
        stated: &Spanned<MassTable>,
    ) -> Result<Mass, Failure> {
        let refuse = |message: String| Err(self.task.source.refuse(&stated.span(), message));
        let part = name.get_ref();
        let mass = match stated.get_ref() {
            MassTable::Alone(mass) | MassTable::OfBody(BodyMass { mass, .. }) => *mass,
        };
        if !(mass.is_finite() && mass >= 0.0) {
            return refuse(format!(
                "the mass of `{part}` must be zero or a positive number of kg"
            ));
        }
        let statements = self.listing.statements();
        let statement = statements.iter().find(|statement| statement.name == part);
        let ends = statement.and_then(Statement::ends);
        if let (Some(ends), MassTable::Alone(mass)) = (ends, stated.get_ref()) {
            return Ok(Mass::Rod(ends, *mass));
        }
        match (statement, stated.get_ref()) {
            (Some(body), MassTable::OfBody(stated)) if is_body(body) => {
                self.read_body(&body.points, stated, part)
            }
            (Some(body), MassTable::Alone(_)) if is_body(body) => refuse(format!(
                "`{part}` is a body: write {{ mass = ..., centre = \"point\" or [x, y, z], inertia = [xx, yy, zz] }}"
            )),
            (Some(link), _) if link.kind == Kind::LINK => {
                refuse(format!("`{part}` is a link: write only its mass, in kg"))
            }
            (None, MassTable::Alone(mass)) => Ok(Mass::At(self.point(name)?, *mass)),
            _ => Err(self.unknown(name)),
        }
    }

    /// A point that moves: a free point, a marker, or a chassis point that a drive moves.
    fn point(&self, name: &Spanned<String>) -> Result<usize, Failure> {
        let mut moving = self.moving_points();
        let point = moving.find(|point| self.task.names.points[*point] == *name.get_ref());
        point.ok_or_else(|| self.unknown(name))
    }

    fn moving_points(&self) -> impl Iterator<Item = usize> {
        let names = &self.task.names;
        let driven = self.listing.driven_points();
        let points = 0..names.points.len();
        points.filter(move |point| *point >= names.chassis || driven.contains(point))
    }

    fn unknown(&self, name: &Spanned<String>) -> Failure {
        let statements = self.listing.statements().into_iter();
        let parts = statements.filter(|part| part.kind == Kind::LINK || is_body(part));
        let names = &self.task.names;
        let known: Vec<&str> = parts
            .map(|part| part.name)
            .chain(
                self.moving_points()
                    .map(|point| names.points[point].as_str()),
            )
            .collect();
        let message = unknown("moving part", name.get_ref(), &known);
        self.task.source.refuse(&name.span(), message)
    }

    fn read_body(&self, points: &[usize], stated: &BodyMass, name: &str) -> Result<Mass, Failure> {
        let metre = self.task.file.unit().metre();
        let local = |point: Vector3<f64>| (point - self.origin) / metre;
        let (centre, named) = match stated.centre.get_ref() {
            Centre::At(centre) => (Vector3::from(*centre), None),
            Centre::Point(point) => {
                let mut points = self.task.names.points.iter().zip(self.design).enumerate();
                let found = points.find(|(_, (name, _))| *name == point);
                let (number, (_, at)) = found.ok_or_else(|| {
                    let message = unknown("point", point, &self.task.names.point_names());
                    self.task.source.refuse(&stated.centre.span(), message)
                })?;
                (*at, Some(number))
            }
        };
        let inertia = match *stated.inertia.as_slice() {
            [] => Some(Matrix3::zeros()),
            [xx, yy, zz] => Some(Matrix3::from_diagonal(&Vector3::new(xx, yy, zz))),
            [xx, yy, zz, xy, yz, zx] => Some(Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz)),
            _ => None,
        };
        if !centre.iter().all(|coordinate| coordinate.is_finite()) {
            let message = format!("the centre of mass of `{name}` is not finite");
            return Err(self.task.source.refuse(&stated.centre.span(), message));
        }
        let inertia = inertia.filter(is_inertia).ok_or_else(|| {
            let message = format!(
                "the inertia of `{name}` must be [xx, yy, zz] or [xx, yy, zz, xy, yz, zx] in kg m^2, and no principal moment of inertia \
                 may be negative or larger than the sum of the other two"
            );
            self.task.source.refuse(&stated.centre.span(), message)
        })?;
        let held = widest(points, self.design);
        let body = RigidBody {
            points: held.map(|point| local(self.design[point])),
            mass: stated.mass,
            centre: local(centre),
            inertia,
        };
        Ok(Mass::Body {
            held,
            body,
            centre: named,
        })
    }
}

fn is_body(statement: &Statement<'_>) -> bool {
    [Kind::BODY, Kind::HINGE].contains(&statement.kind)
}

/// Whether a distribution of mass with this inertia exists.
fn is_inertia(inertia: &Matrix3<f64>) -> bool {
    const ROUNDING: f64 = 1e-9;
    if !inertia.iter().all(|entry| entry.is_finite()) {
        return false;
    }
    let principal = inertia.symmetric_eigenvalues();
    let largest = principal.max();
    let others = principal.sum() - largest;
    principal.min() >= -ROUNDING * largest && largest <= others + ROUNDING * largest
}

/// The three points that make the largest triangle.
fn widest(points: &[usize], at: &[Vector3<f64>]) -> [usize; 3] {
    let area = |[a, b, c]: [usize; 3]| (at[b] - at[a]).cross(&(at[c] - at[a])).norm();
    let mut best = [points[0], points[1], points[2]];
    for (second, b) in points.iter().enumerate() {
        for a in &points[..second] {
            for c in &points[second + 1..] {
                if area([*a, *b, *c]) > area(best) {
                    best = [*a, *b, *c];
                }
            }
        }
    }
    best
}
