//! What load cases do to the parts of a mechanism: what its drives bear, the force in each link, and the forces that
//! bodies exert at their joints.

use std::ops::Range;

use nalgebra::{DMatrix, DVector, Vector3};
use suspension_core::listing::{DriveKind, MeasureKind};
use suspension_core::statics::spread;
use suspension_core::wheel::contact;
use suspension_runtime::{Listing, Statement};

use crate::mechanism::{Description, Place, State};

/// A load case: what acts where.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// Its name.
    pub name: String,
    /// Forces, N, and moments, N m, at places.
    pub at: Vec<(Site, [Vector3<f64>; 2])>,
    /// Measures by number, with what makes each larger: N, or N m of an angle.
    pub along: Vec<(usize, f64)>,
    /// Drives that bear nothing, each with the measure that does, a spring's say; both by number.
    pub borne_by: Vec<(usize, usize)>,
}

/// Where a load acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Site {
    /// At a free point, which passes the load to whatever it joins.
    Point(usize),
    /// At a point of a body that these three points determine.
    Body(usize, [usize; 3]),
    /// Where a wheel by this number touches the ground, the wheel being held by its carrier.
    Contact(usize),
}

/// What a case does at a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// What each drive bears: N, or N m about an angle.
    pub on_drives: Vec<f64>,
    /// What acts in each measure that bears the load of a drive, as in [`Case::along`].
    pub in_measures: Vec<(usize, f64)>,
    /// The force in each link, N, positive in tension, by the number of its statement.
    pub links: Vec<(usize, f64)>,
    /// The force, N, that each other statement exerts on each of its points, both by number.
    pub joints: Vec<(usize, usize, Vector3<f64>)>,
}

/// The statements of a listing that hold its points.
pub struct Structure<'l> {
    /// They, in the order of their equations.
    pub statements: Vec<Statement<'l>>,
    groups: Vec<Vec<Range<usize>>>,
    /// Markers with three points of the body that carries each.
    carriers: Vec<(usize, [usize; 3])>,
}

/// A force at a point, with the body on which it acts, where it does not act on the point itself.
struct Force {
    point: usize,
    force: Vector3<f64>,
    body: Option<[usize; 3]>,
}

impl<'l> Structure<'l> {
    /// That of a listing. Drives of free points are no part of it: [`Outcome::on_drives`] has what they bear.
    pub fn of(listing: &'l Listing) -> Self {
        let statements = listing.statements().into_iter();
        let statements: Vec<_> = statements.filter(|each| each.kind != "drive").collect();
        let groups = statements.iter().map(|each| each.equations.clone());
        Self {
            groups: groups.collect(),
            carriers: listing.carriers(),
            statements,
        }
    }

    /// What a case does at a place; `None` where the mechanism locks.
    pub fn under(
        &self,
        mechanism: &Description,
        case: &Case,
        place: &dyn Place,
    ) -> Option<Outcome> {
        let state = place.state();
        let mut forces = self.at_places(mechanism, case, &state);
        for (measure, along) in &case.along {
            forces.extend(self.in_measure(mechanism, *measure, *along, place, &state));
        }
        let bearing = self.bearing(mechanism, case, &forces, place, &state)?;
        for (measure, along) in &bearing {
            forces.extend(self.in_measure(mechanism, *measure, *along, place, &state));
        }
        let borne = place.under(&summed(&forces, &state), &self.groups)?;
        let mut outcome = Outcome {
            on_drives: in_newton_metres(mechanism, borne.on_drives),
            in_measures: bearing,
            links: Vec::new(),
            joints: Vec::new(),
        };
        for (number, mut by) in borne.by_groups.into_iter().enumerate() {
            let statement = &self.statements[number];
            for Force { point, force, .. } in forces.iter().filter(|force| force.is_on(statement)) {
                by[*point] += force;
            }
            match statement.points.as_slice() {
                [from, to] if statement.kind == "link" => {
                    let along = state.points.value[*to] - state.points.value[*from];
                    outcome
                        .links
                        .push((number, by[*from].dot(&along.normalize())));
                }
                points => {
                    let at = points.iter().map(|point| (number, *point, by[*point]));
                    outcome.joints.extend(at);
                }
            }
        }
        Some(outcome)
    }

    /// What measures must bear so that their drives bear nothing; `None` where they cannot.
    fn bearing(
        &self,
        mechanism: &Description,
        case: &Case,
        forces: &[Force],
        place: &dyn Place,
        state: &State,
    ) -> Option<Vec<(usize, f64)>> {
        let on_drives = |forces: &[Force]| {
            let borne = place.under(&summed(forces, state), &[])?.on_drives;
            let relieved = case.borne_by.iter().map(|(drive, _)| borne[*drive]);
            Some(DVector::from_iterator(case.borne_by.len(), relieved))
        };
        if case.borne_by.is_empty() {
            return Some(Vec::new());
        }
        let of_units = case.borne_by.iter().map(|(_, measure)| {
            let unit: Vec<Force> = self.in_measure(mechanism, *measure, 1.0, place, state);
            on_drives(&unit)
        });
        let of_units: Vec<DVector<f64>> = of_units.collect::<Option<_>>()?;
        let loads = on_drives(forces)?;
        let along = DMatrix::from_columns(&of_units).lu().solve(&-loads)?;
        let measures = case.borne_by.iter().map(|(_, measure)| *measure);
        let is_finite = along.iter().all(|along| along.is_finite());
        is_finite.then(|| measures.zip(along.iter().copied()).collect())
    }

    /// The forces of a case at places, those on bodies spread over three points of each.
    fn at_places(&self, mechanism: &Description, case: &Case, state: &State) -> Vec<Force> {
        let points = &state.points.value;
        let metre = mechanism.unit.metre();
        let mut forces = Vec::new();
        for (site, [force, moment]) in &case.at {
            let load = [*force, moment * metre];
            match *site {
                Site::Point(point) => forces.push(Force::at(point, *force)),
                Site::Body(point, body) => {
                    forces.extend(Force::spread(points, body, points[point], load));
                }
                Site::Contact(wheel) => {
                    let body = mechanism.names.wheels[wheel].points.carrier;
                    let at = touching(mechanism, wheel, state);
                    forces.extend(Force::spread(points, body, at, load));
                }
            }
        }
        forces
    }

    /// The forces at the points of a measure.
    fn in_measure(
        &self,
        mechanism: &Description,
        measure: usize,
        along: f64,
        place: &dyn Place,
        state: &State,
    ) -> Vec<Force> {
        let is_angle = mechanism.names.measures[measure].kind == MeasureKind::Angle;
        let along = if is_angle {
            along * mechanism.unit.metre()
        } else {
            along
        };
        let points = &state.points.value;
        let mut forces = Vec::new();
        for (point, gradient) in place.gradient(measure).into_iter().enumerate() {
            let force = gradient * along;
            match self.carriers.iter().find(|(marker, _)| *marker == point) {
                None => forces.push(Force::at(point, force)),
                Some((_, body)) => {
                    let alone = [force, Vector3::zeros()];
                    forces.extend(Force::spread(points, *body, points[point], alone));
                }
            }
        }
        forces
    }
}

/// The forces at each point together.
fn summed(forces: &[Force], state: &State) -> Vec<Vector3<f64>> {
    let mut sums = vec![Vector3::zeros(); state.points.value.len()];
    for Force { point, force, .. } in forces {
        sums[*point] += force;
    }
    sums
}

impl Force {
    fn at(point: usize, force: Vector3<f64>) -> Self {
        let body = None;
        Self { point, force, body }
    }

    /// A force and a moment at a place of a body.
    fn spread(
        points: &[Vector3<f64>],
        body: [usize; 3],
        place: Vector3<f64>,
        [force, moment]: [Vector3<f64>; 2],
    ) -> impl Iterator<Item = Self> {
        let parts = spread(body.map(|point| points[point]), force, place, moment);
        let each = body.into_iter().zip(parts);
        each.map(move |(point, force)| Self {
            point,
            force,
            body: Some(body),
        })
    }

    /// Whether it acts on the body of a statement.
    fn is_on(&self, statement: &Statement<'_>) -> bool {
        let has = |points: [usize; 3]| points.iter().all(|point| statement.points.contains(point));
        self.body.is_some_and(has)
    }
}

/// Moments about angles per metre, not per the unit of lengths.
fn in_newton_metres(mechanism: &Description, mut on_drives: Vec<f64>) -> Vec<f64> {
    for (load, drive) in on_drives.iter_mut().zip(&mechanism.names.drives) {
        if drive.kind == DriveKind::Angle {
            *load /= mechanism.unit.metre();
        }
    }
    on_drives
}

/// Where a wheel touches the ground, in local coordinates.
fn touching(mechanism: &Description, wheel: usize, state: &State) -> Vector3<f64> {
    let wheel = &mechanism.names.wheels[wheel];
    let axis = wheel.points.axis;
    let [inner, centre] = axis.map(|point| state.axes.turned(state.points.value[point]));
    let radius = wheel.radius.unwrap_or(f64::NAN);
    state
        .axes
        .turned(contact(&centre, &(centre - inner), radius))
}
