//! Weight and inertia of moving parts, as forces at their points (d'Alembert). With these forces
//! [`statics`](crate::statics) applies to a moving mechanism.
//!
//! Masses, lengths and times must be in consistent units: kg, m and s give N, and so do t, mm and s. Accelerations are relative to the
//! chassis; subtract an acceleration of the chassis itself from `gravity`.

use nalgebra::{Matrix3, Vector3};

use crate::arithmetic::scalar::Real;
use crate::body::{angular_acceleration, angular_velocity, pose};
use crate::signal::Signal;
use crate::statics::spread;

/// Mass, centre of mass and inertia of a rigid body, with three of its points.
///
/// ```
/// use suspension_core::Signal;
/// use suspension_core::inertia::RigidBody;
/// use suspension_core::nalgebra::{Matrix3, Vector3};
///
/// let points = [Vector3::x(), Vector3::y(), Vector3::z()];
/// let wheel = RigidBody { points, mass: 20.0, centre: Vector3::zeros(), inertia: Matrix3::identity() };
/// let forces = wheel.forces(&Signal::still(points), &Vector3::new(0.0, 0.0, -9.81)).ok_or("in line")?;
/// let weight: Vector3<f64> = forces.iter().sum();
/// assert!((weight.z + 196.2).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidBody<T> {
    /// Three points of the body, not collinear, in the position for which centre and inertia are stated, for example
    /// the design.
    pub points: [Vector3<T>; 3],
    /// Its mass.
    pub mass: T,
    /// Its centre of mass.
    pub centre: Vector3<T>,
    /// Its inertia about the centre of mass, in the axes of the points. The entries off the diagonal are the negative
    /// products of inertia, `-sum m x y`.
    pub inertia: Matrix3<T>,
}

impl<T: Real> RigidBody<T> {
    /// The forces at the three points that are together equivalent to the body's weight in a field `gravity` and its
    /// inertia: the force `m (g - a)` at the centre of mass and the moment `-(I alpha + omega x I omega)` about it.
    /// `None` if the points are collinear, or a number is not finite.
    pub fn forces(
        &self,
        points: &Signal<[Vector3<T>; 3]>,
        gravity: &Vector3<T>,
    ) -> Option<[Vector3<T>; 3]> {
        let Signal {
            value: at,
            rate: velocities,
            second_rate: accelerations,
        } = points;
        let omega = angular_velocity(at, velocities)?;
        let alpha = angular_acceleration(at, &omega, accelerations)?;
        let moved = pose(&self.points, at)?;
        let turned = moved.rotation.to_rotation_matrix();
        let inertia = turned * self.inertia * turned.transpose();
        let centre = moved * nalgebra::Point3::from(self.centre);
        let ([first, ..], [of_first, ..]) = (at, accelerations);
        let arm = centre.coords - first;
        let acceleration = of_first + alpha.cross(&arm) + omega.cross(&omega.cross(&arm));
        let force = (gravity - acceleration) * self.mass;
        let moment = -(inertia * alpha + omega.cross(&(inertia * omega)));
        let forces = spread(*at, force, centre.coords, moment);
        let is_finite = forces
            .iter()
            .all(|force| force.iter().all(|part| part.is_finite()));
        is_finite.then_some(forces)
    }
}

/// Weight and inertia of a uniform thin rod as forces at its ends; the force at the first end is `m ((g - a1) / 3 +
/// (g - a2) / 6)`.
pub fn rod<T: Real>(
    mass: T,
    accelerations: [Vector3<T>; 2],
    gravity: &Vector3<T>,
) -> [Vector3<T>; 2] {
    let [first, second] = accelerations.map(|acceleration| (gravity - acceleration) * mass);
    let two = T::constant(2.0);
    let sixth = T::one() / T::constant(6.0);
    [
        (first * two + second) * sixth,
        (second * two + first) * sixth,
    ]
}
