//! The contribution of a corner to the equations of motion.
//!
//! These are Kane's equations with the speeds of the chassis, the rate of travel and the wheel's angular velocity about its axis. The unsprung
//! mass is at the wheel centre. The wheel has a moment of inertia only about its axis. Its spin therefore has its own equation
//! and loads the carrier with the gyroscopic moment `-I spin (turning x axis)`.

use nalgebra::{Matrix3, Matrix6, Vector6};

use super::{Corner, Ground, Torque};
use crate::chassis::{Equations, Frame, both};
use crate::kinematics::Hub;

/// A corner's travel, eliminated from the equations of motion: `inertia b'' + coupling . a = force`.
#[derive(Clone, Copy, Debug)]
pub struct Eliminated {
    inertia: f64,
    coupling: Vector6<f64>,
    force: f64,
    spin_rate: f64,
}

impl Corner {
    /// Adds the corner to the chassis' equations, its travel eliminated; `bar` is the force of the anti-roll bar on the
    /// travel, N.
    pub fn add_to(
        &self,
        equations: &mut Equations,
        frame: &Frame,
        torque: &Torque,
        bar: f64,
        dt: f64,
    ) -> Eliminated {
        let Hub {
            centre,
            axis,
            per_travel,
            strut,
            ..
        } = self.hub;
        let Ground {
            contact,
            force: ground,
            carrier,
            ..
        } = self.ground;
        let turning = frame.turning;
        let own = centre.second_rate - per_travel.centre * self.travel_second_rate;
        let convective = turning.cross(&(turning.cross(&centre.value) + centre.rate * 2.0)) + own;
        let mass = self.unsprung_mass;
        let force = ground + (frame.gravity - convective) * mass;

        let of_ground = contact.arm.cross(&ground);
        let spinning = of_ground.dot(&axis);
        let gyroscopic = carrier.cross(&axis) * (-self.spin_inertia * self.spin);
        let brake = self.brake(torque, dt);
        let moment = of_ground - axis * (spinning - brake) + gyroscopic;

        let arm = centre.value.cross_matrix();
        equations.mass += point_mass(mass, &arm);
        equations.force += both(&force, &(arm * force + moment - axis * torque.drive));
        let row = Eliminated {
            inertia: mass * per_travel.centre.norm_squared(),
            coupling: both(&per_travel.centre, &(arm * per_travel.centre)) * mass,
            force: per_travel.centre.dot(&force)
                + per_travel.turn.dot(&moment)
                + per_travel.strut * self.strut.force(strut)
                + self.strut.stop_force(self.travel)
                + bar,
            spin_rate: (spinning + torque.drive - brake) / self.spin_inertia,
        };
        equations.mass -= row.coupling * row.coupling.transpose() / row.inertia;
        equations.force -= row.coupling * (row.force / row.inertia);
        row
    }

    /// Semi-implicit Euler, under the chassis' accelerations.
    pub fn advance(&mut self, row: &Eliminated, chassis: &Vector6<f64>, dt: f64) {
        self.travel_second_rate = (row.force - row.coupling.dot(chassis)) / row.inertia;
        self.travel_rate += self.travel_second_rate * dt;
        self.travel += self.travel_rate * dt;
        self.spin += row.spin_rate * dt;
    }
}

/// The mass matrix of a mass at the end of an arm, given the matrix of the arm's cross product.
fn point_mass(mass: f64, arm: &Matrix3<f64>) -> Matrix6<f64> {
    let mut matrix = Matrix6::zeros();
    matrix.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(mass);
    matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&(arm * mass));
    matrix
        .fixed_view_mut::<3, 3>(0, 3)
        .copy_from(&(arm * -mass));
    matrix
        .fixed_view_mut::<3, 3>(3, 3)
        .copy_from(&(arm * arm * -mass));
    matrix
}
