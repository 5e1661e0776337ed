//! The chassis: a rigid body with six degrees of freedom.

use nalgebra::{Cholesky, Const, Matrix3, Matrix6, UnitQuaternion, Vector3, Vector6};

use crate::saloon::GRAVITY;

/// The sprung mass, its centre the origin of the chassis axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chassis {
    /// The position of the origin, in world axes, m.
    pub position: Vector3<f64>,
    /// The rotation from chassis axes to world axes.
    pub attitude: UnitQuaternion<f64>,
    /// The velocity of the origin, in world axes, m/s.
    pub velocity: Vector3<f64>,
    /// Angular velocity, in chassis axes, rad/s.
    pub turning: Vector3<f64>,
    mass: f64,
    inertia: Matrix3<f64>,
}

/// The state of the chassis in the form that a tick uses repeatedly, vectors in chassis axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The position of the origin, in world axes, m.
    pub position: Vector3<f64>,
    /// The rotation from chassis axes to world axes.
    pub rotation: Matrix3<f64>,
    /// The velocity of the origin, m/s.
    pub velocity: Vector3<f64>,
    /// rad/s.
    pub turning: Vector3<f64>,
    /// m/s^2.
    pub gravity: Vector3<f64>,
}

/// The chassis' equations of motion: mass times accelerations (of the origin, angular, in chassis axes) is force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equations {
    /// The mass matrix of the chassis and of the parts that move with it.
    pub mass: Matrix6<f64>,
    /// Forces, then moments about the origin.
    pub force: Vector6<f64>,
}

impl Chassis {
    /// Level, its centre of mass above the world's origin.
    pub fn level(mass: f64, inertia: Matrix3<f64>, height: f64) -> Self {
        Self {
            position: Vector3::new(0.0, 0.0, height),
            attitude: UnitQuaternion::identity(),
            velocity: Vector3::zeros(),
            turning: Vector3::zeros(),
            mass,
            inertia,
        }
    }

    /// Returns the state in the form of a [`Frame`].
    pub fn frame(&self) -> Frame {
        let rotation = self.attitude.to_rotation_matrix().into_inner();
        Frame {
            position: self.position,
            rotation,
            velocity: rotation.tr_mul(&self.velocity),
            turning: self.turning,
            gravity: rotation.tr_mul(&Vector3::new(0.0, 0.0, -GRAVITY)),
        }
    }

    /// Returns the chassis' own part of the equations.
    pub fn equations(&self, frame: &Frame) -> Equations {
        let mut mass = Matrix6::zeros();
        mass.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(self.mass);
        mass.fixed_view_mut::<3, 3>(3, 3).copy_from(&self.inertia);
        let gyroscopic = -self.turning.cross(&(self.inertia * self.turning));
        Equations {
            mass,
            force: both(&(frame.gravity * self.mass), &gyroscopic),
        }
    }

    /// Semi-implicit Euler: velocities by the accelerations, then the place by the new velocities.
    pub fn advance(&mut self, frame: &Frame, acceleration: &Vector6<f64>, dt: f64) {
        let [linear, angular] = halves(acceleration);
        self.velocity += frame.rotation * linear * dt;
        self.turning += angular * dt;
        self.position += self.velocity * dt;
        self.attitude *= UnitQuaternion::from_scaled_axis(self.turning * dt);
        // Each product of quaternions rounds the length.
        self.attitude.renormalize_fast();
    }

    /// Returns the kinetic and the potential energy, J.
    pub fn energy(&self) -> f64 {
        let turning = self.turning.dot(&(self.inertia * self.turning));
        0.5 * (self.mass * self.velocity.norm_squared() + turning)
            + self.mass * GRAVITY * self.position.z
    }
}

impl Equations {
    /// Returns the accelerations; `None` if the mass matrix is not positive definite.
    pub fn solve(&self) -> Option<Vector6<f64>> {
        let factors: Cholesky<f64, Const<6>> = self.mass.cholesky()?;
        Some(factors.solve(&self.force))
    }
}

/// Joins a force and a moment to one vector.
pub fn both(force: &Vector3<f64>, moment: &Vector3<f64>) -> Vector6<f64> {
    Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
}

fn halves(both: &Vector6<f64>) -> [Vector3<f64>; 2] {
    [
        both.fixed_rows::<3>(0).into(),
        both.fixed_rows::<3>(3).into(),
    ]
}
