//! The effects of load cases on a mechanism: the forces on its drives, the force in each link, and the forces that
//! bodies exert at their joints.

mod chassis_forces;
mod forces;
mod measure_loads;
mod moments;
mod outcome;
mod shared_joints;
mod site;
mod springs_left_out;
mod unborne;

use std::cell::OnceCell;

use nalgebra::Vector3;
use suspension_core::listing::{self, Parts};
use suspension_runtime::{AngleShare, Listing, PartForces, Statement};

use crate::kinematics::Kinematics;
use crate::mechanism::{Borne, Description, Names, State};
use forces::{Force, Here};
use measure_loads::{add_stated, loads_borne_by_measures};
use shared_joints::Shared;

pub use outcome::{By, Outcome};
pub use site::{Site, contact_of};
pub use unborne::{OneSided, Unborne};

/// A load case: the loads and where they act.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// Its name.
    pub name: String,
    /// Forces, N, and moments, N m, at places.
    pub at: Vec<(Site, [Vector3<f64>; 2])>,
    /// Measures by number, with the load that tends to increase each: N, or N m for an angle.
    pub along: Vec<(usize, f64)>,
    /// Springs by number that act by their rates. None of them is along a measure that bears the load of a drive.
    pub acting: Vec<usize>,
    /// The field that acts on each kilogram of the parts that have a mass: gravity minus the acceleration of the
    /// chassis, m/s^2.
    pub field: Vector3<f64>,
    /// Drives that bear nothing, each with the measure that bears its load, for example that of a spring; both by
    /// number.
    pub borne_by: Vec<(usize, usize)>,
}

/// The statements of a listing that hold its points.
pub struct Structure<'l> {
    /// The statements, in the order of their equations.
    pub statements: Vec<Statement<'l>>,
    /// The drives of lengths.
    actuators: Vec<Statement<'l>>,
    /// The contributions to the forces of the statements, then of the actuators.
    part_forces: Vec<PartForces>,
    /// For each measure, the shares of parts in the load along it.
    measured: Vec<Vec<AngleShare>>,
    /// For each measure, the points on which it acts with forces.
    measured_points: Vec<Vec<usize>>,
    /// The number of chassis points, which are the first of all points.
    chassis: usize,
    /// Markers with three points of the body that carries each. A force at another marker acts on the points that carry it.
    carriers: Vec<(usize, [usize; 3])>,
    /// The pairs of joints that share the force along their line.
    shared: Vec<Shared>,
}

impl<'l> Structure<'l> {
    /// The structure of a listing. It does not contain drives of free points: [`Outcome::on_drives`] has what they
    /// bear.
    pub fn new(listing: &'l Listing) -> Self {
        let actuators: Vec<Statement<'l>> = listing.actuators().collect();
        let of_actuators = actuators.iter().map(PartForces::from_statement);
        let statements: Vec<Statement<'l>> = listing.parts().collect();
        let chassis = listing.count(listing::Kind::ChassisPoint);
        Self {
            part_forces: listing
                .part_forces()
                .into_iter()
                .chain(of_actuators)
                .collect(),
            actuators,
            measured: listing.shares_in_measures(),
            measured_points: listing.points_of_measures(),
            carriers: listing.rigid_carriers(),
            shared: Shared::all(&statements, chassis),
            chassis,
            statements,
        }
    }

    /// The effect of a case at a state; `None` if the mechanism locks, if a measure that should bear the load of a
    /// drive does not move with it, and if points that hold a body with a mass are collinear.
    pub fn solve(&self, mechanism: &dyn Kinematics, case: &Case, state: &State) -> Option<Outcome> {
        let here = self.here(mechanism, state);
        let mut forces = here.forces_at_sites(&case.at);
        let of_springs = self.of_springs(case, state);
        forces.extend(here.forces_in_measures(&[case.along.as_slice(), &of_springs].concat()));
        forces.extend(here.forces_of_masses(&case.field)?);
        let bearing = loads_borne_by_measures(&here, &case.borne_by, &forces)?;
        forces.extend(here.forces_in_measures(&bearing));
        let Borne {
            on_drives,
            mut by_parts,
            on_parts,
        } = here.solve(&forces, &self.part_forces)?;
        let by_actuators = by_parts.split_off(self.statements.len());
        let in_measures = [bearing, of_springs].concat();
        let along = self.sum_by_measure(&[case.along.as_slice(), &in_measures].concat());
        let at_ends = self.forces_at_ends(&here, &along);
        let mut outcome = Outcome {
            on_drives: in_newton_metres(mechanism, on_drives),
            in_measures: add_stated(in_measures, &case.along),
            links: Vec::new(),
            joints: Vec::new(),
            moments: [
                moments::moments_of_angles(on_parts, &self.statements, &mechanism.names),
                moments::moments_in_measures(&here, &along),
            ]
            .concat(),
            on_chassis: Vec::new(),
            largest_load: forces
                .iter()
                .map(|each| each.force.norm())
                .fold(0.0, f64::max),
        };
        for (number, by) in by_parts.into_iter().enumerate() {
            let own = forces.iter();
            let own = own.filter(|force| force.is_on(number, &self.statements[number]));
            self.add(&mut outcome, number, (by, own.collect()), here.points());
            self.add_at_markers(&mut outcome, number, &at_ends);
        }
        for shared in &self.shared {
            shared.halve(&mut outcome.joints, here.points());
        }
        outcome.joints.extend(at_ends);
        outcome.on_chassis = self.on_chassis(&outcome, &by_actuators, here.points());
        Some(outcome)
    }

    /// The name of the part, measure or drive that exerts a force at a joint, or a moment on a part.
    pub fn name_of<'n>(&'n self, by: By, names: &'n Names) -> &'n str {
        match by {
            By::Part(number) => self.statements[number].name,
            By::Measure(number) => &names.measures[number].name,
            By::Drive(number) => &names.drives[number].name,
        }
    }

    /// The pairs of joints that share the force along their line, by the part on them and the other part; without it they are
    /// the bushes of a hinge.
    pub fn shared(&self) -> impl Iterator<Item = (By, Option<By>)> {
        let parts = self.shared.iter().map(|shared| shared.parts);
        parts.map(|(part, with)| (By::Part(part), with.map(By::Part)))
    }

    /// The places where the loads of a case act, in the file's coordinates, and their forces, N.
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
            gradients: OnceCell::new(),
        }
    }

    /// Adds the forces `by` a statement on all points, with the loads on the part itself, which it passes on.
    fn add(
        &self,
        outcome: &mut Outcome,
        number: usize,
        (mut by, own): (Vec<Vector3<f64>>, Vec<&Force>),
        at: &[Vector3<f64>],
    ) {
        let (statement, forces) = (&self.statements[number], &self.part_forces[number]);
        if forces.all_on_others() {
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
        let joints = statement.points.iter();
        let joints = joints.map(|point| (By::Part(number), *point, by[*point]));
        outcome.joints.extend(joints);
    }
}

/// Converts moments about angles to newton metres from newtons times the unit of lengths.
fn in_newton_metres(mechanism: &Description, mut on_drives: Vec<f64>) -> Vec<f64> {
    for (load, drive) in on_drives.iter_mut().zip(&mechanism.names.drives) {
        if drive.kind.is_angle() {
            *load /= mechanism.unit.metre();
        }
    }
    on_drives
}
