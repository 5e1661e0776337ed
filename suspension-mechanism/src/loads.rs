//! What load cases do to the parts of a mechanism: what its drives bear, the force in each link, and the forces that
//! bodies exert at their joints.

mod forces;
mod site;

use nalgebra::{DMatrix, DVector, Vector3};
use suspension_core::listing::{self, Parts};
use suspension_listing::Kind;
use suspension_runtime::{AngleShare, Listing, PartForces, Statement};

use crate::kinematics::Kinematics;
use crate::mechanism::{Borne, Description, State};
use forces::{Force, Here, summed};

pub use site::Site;

/// A load case: what acts where.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// Its name.
    pub name: String,
    /// Forces, N, and moments, N m, at places.
    pub at: Vec<(Site, [Vector3<f64>; 2])>,
    /// Measures by number, with what makes each larger: N, or N m of an angle.
    pub along: Vec<(usize, f64)>,
    /// What acts on each kilogram of the parts that have a mass: gravity, less the acceleration of the chassis, m/s^2.
    pub field: Vector3<f64>,
    /// Drives that bear nothing, each with the measure that does, a spring's say; both by number.
    pub borne_by: Vec<(usize, usize)>,
}

/// What a case does at a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// What each drive bears: N, or N m about an angle.
    pub on_drives: Vec<f64>,
    /// What acts in each measure that bears the load of a drive, as in [`Case::along`].
    pub in_measures: Vec<(usize, f64)>,
    /// The force in each link, N, positive in tension, by the number of its statement; of a link with a mass at its middle,
    /// but for what spinning adds.
    pub links: Vec<(usize, f64)>,
    /// The force, N, that each other statement, and each link with a mass, exerts on each of its points, both by number.
    pub joints: Vec<(usize, usize, Vector3<f64>)>,
    /// The largest force that acts at a point, N: of the loads, of what bears drives' loads, of weight and inertia.
    pub largest_load: f64,
}

impl Outcome {
    /// How many times the largest force that acts the largest one inside is: without bound where the mechanism locks.
    pub fn amplification(&self) -> f64 {
        let links = self.links.iter().map(|(_, tension)| tension.abs());
        let joints = self.joints.iter().map(|(.., force)| force.norm());
        let largest = links.chain(joints).fold(0.0, f64::max);
        if largest == 0.0 {
            0.0
        } else {
            largest / self.largest_load
        }
    }
}

/// The statements of a listing that hold its points.
pub struct Structure<'l> {
    /// They, in the order of their equations.
    pub statements: Vec<Statement<'l>>,
    part_forces: Vec<PartForces>,
    /// Of each measure the shares of parts in what acts along it.
    measured: Vec<Vec<AngleShare>>,
    /// How many chassis points there are, the first of all points.
    chassis: usize,
    /// Markers with three points of the body that carries each.
    carriers: Vec<(usize, [usize; 3])>,
}

impl<'l> Structure<'l> {
    /// That of a listing. Drives of free points are no part of it: [`Outcome::on_drives`] has what
    /// they bear.
    pub fn of(listing: &'l Listing) -> Self {
        Self {
            part_forces: listing.part_forces(),
            measured: listing.shares_in_measures(),
            carriers: listing.carriers(),
            chassis: listing.count(listing::Kind::ChassisPoint),
            statements: listing.parts().collect(),
        }
    }

    /// What a case does at a state; `None` where the mechanism locks, where what is to bear the load of a drive does not
    /// move with it, and where points that hold a body with a mass are in line.
    pub fn under(&self, mechanism: &dyn Kinematics, case: &Case, state: &State) -> Option<Outcome> {
        let here = self.here(mechanism, state);
        let mut forces = here.at_sites(&case.at);
        forces.extend(here.in_measures(&case.along));
        forces.extend(here.of_masses(&case.field)?);
        let in_measures = bearing(&here, &case.borne_by, &forces)?;
        forces.extend(here.in_measures(&in_measures));
        let Borne {
            on_drives,
            by_parts,
        } = here.under(&summed(&forces, here.points()), &self.part_forces)?;
        let mut outcome = Outcome {
            on_drives: in_newton_metres(mechanism, on_drives),
            in_measures,
            links: Vec::new(),
            joints: Vec::new(),
            largest_load: forces
                .iter()
                .map(|each| each.force.norm())
                .fold(0.0, f64::max),
        };
        for (number, by) in by_parts.into_iter().enumerate() {
            let own = forces.iter();
            let own = own.filter(|force| force.is_on(number, &self.statements[number]));
            self.add(&mut outcome, number, (by, own.collect()), here.points());
        }
        Some(outcome)
    }

    /// Where the loads of a case act at places, in the file's coordinates, and their forces, N.
    pub fn acting(
        &self,
        mechanism: &dyn Kinematics,
        case: &Case,
        state: &State,
    ) -> Vec<[Vector3<f64>; 2]> {
        let here = self.here(mechanism, state);
        let each = case.at.iter();
        each.map(|(site, [force, _])| [here.place_of(*site) + state.origin, *force])
            .collect()
    }

    fn here<'a>(&'a self, mechanism: &'a dyn Kinematics, state: &'a State) -> Here<'a> {
        Here {
            mechanism,
            carriers: &self.carriers,
            measured: &self.measured,
            state,
        }
    }

    /// Adds the forces `by` a statement on all points, with what acts on the part itself, which it passes on.
    fn add(
        &self,
        outcome: &mut Outcome,
        number: usize,
        (mut by, own): (Vec<Vector3<f64>>, Vec<&Force>),
        at: &[Vector3<f64>],
    ) {
        let (statement, forces) = (&self.statements[number], &self.part_forces[number]);
        if forces.are_of_others() {
            return;
        }
        let (moments, own): (Vec<&Force>, Vec<_>) =
            own.into_iter().partition(|force| force.is_of_angle());
        let bears_only_tension = own.is_empty() && moments.is_empty() && !forces.bears_moments();
        for force in moments {
            by[force.point] += force.force;
        }
        if let Some([from, to]) = statement.ends() {
            let along = (at[to] - at[from]).normalize();
            outcome.links.push((number, by[from].dot(&along)));
            if bears_only_tension {
                return;
            }
        }
        for force in own {
            by[force.point] += force.force;
        }
        if statement.kind == Kind::HINGE {
            let points = statement.points.iter().copied();
            let axis: Vec<usize> = points.filter(|point| *point < self.chassis).collect();
            if let [first, second] = *axis {
                share_along(&mut by, [first, second], at);
            }
        }
        let joints = statement.points.iter();
        let joints = joints.map(|point| (number, *point, by[*point]));
        outcome.joints.extend(joints);
    }
}

/// What two bushes on the axis of a hinge bear along it is not determined by rigid parts: each has half of it.
fn share_along(by: &mut [Vector3<f64>], ends: [usize; 2], at: &[Vector3<f64>]) {
    let [first, second] = ends;
    let axis = (at[second] - at[first]).normalize();
    let apart = 0.5 * (by[second] - by[first]).dot(&axis);
    by[first] += axis * apart;
    by[second] -= axis * apart;
}

/// Work of a force per unit of a drive that is rounding alone, as a part of the force; the same of singular values.
const ROUNDING: f64 = 1e-12;

/// Whether columns depend on each other but for rounding, whatever the units of columns and rows.
fn is_singular(mut matrix: DMatrix<f64>) -> bool {
    for mut column in matrix.column_iter_mut() {
        column.unscale_mut(column.amax());
    }
    for mut row in matrix.row_iter_mut() {
        row.unscale_mut(row.amax());
    }
    let is_finite = matrix.iter().all(|entry| entry.is_finite());
    !is_finite || matrix.singular_values().min() < ROUNDING
}

/// What measures must bear so that their drives bear nothing; `None` where they cannot.
fn bearing(
    here: &Here<'_>,
    borne_by: &[(usize, usize)],
    forces: &[Force],
) -> Option<Vec<(usize, f64)>> {
    if borne_by.is_empty() {
        return Some(Vec::new());
    }
    let on_drives = |forces: &[Force]| {
        let borne = here.under(&summed(forces, here.points()), &[])?.on_drives;
        let relieved = borne_by.iter().map(|(drive, _)| borne[*drive]);
        Some(DVector::from_iterator(borne_by.len(), relieved))
    };
    let of_unit = |measure: usize| {
        let acting = here.in_measure(measure, 1.0);
        let rounding = ROUNDING * acting.iter().map(|each| each.force.norm()).sum::<f64>();
        let borne = on_drives(&acting)?;
        Some(borne.map(|borne| if borne.abs() > rounding { borne } else { 0.0 }))
    };
    let of_units = borne_by.iter().map(|(_, measure)| of_unit(*measure));
    let of_units: Vec<DVector<f64>> = of_units.collect::<Option<_>>()?;
    let matrix = DMatrix::from_columns(&of_units);
    if is_singular(matrix.clone()) {
        return None;
    }
    let along = matrix.lu().solve(&-on_drives(forces)?)?;
    let measures = borne_by.iter().map(|(_, measure)| *measure);
    let is_finite = along.iter().all(|along| along.is_finite());
    is_finite.then(|| measures.zip(along.iter().copied()).collect())
}

/// Moments about angles per metre, not per the unit of lengths.
fn in_newton_metres(mechanism: &Description, mut on_drives: Vec<f64>) -> Vec<f64> {
    for (load, drive) in on_drives.iter_mut().zip(&mechanism.names.drives) {
        if drive.kind.is_angle() {
            *load /= mechanism.unit.metre();
        }
    }
    on_drives
}
