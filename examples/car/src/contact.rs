//! The contact of a wheel with the plane of the road below it.

use nalgebra::Vector3;

/// A wheel over the plane of the road, in any axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Ahead in the wheel's plane and in the road's, of unit length.
    pub ahead: Vector3<f64>,
    /// The unit vector to the left in the plane of the road.
    pub left: Vector3<f64>,
    /// Out of the road, of unit length.
    pub normal: Vector3<f64>,
    /// The vector from the wheel centre to the contact point, in the plane of the wheel, m.
    pub arm: Vector3<f64>,
    /// The tyre's radius minus the length of that vector, m; negative off the ground.
    pub deflection: f64,
    /// Cosine of the angle between the wheel's plane and the normal.
    pub upright: f64,
}

impl Contact {
    /// Computes the contact of a wheel whose centre is `clearance` above the plane of the road, with its spin axis to the
    /// left and its unloaded radius.
    pub fn new(clearance: f64, normal: Vector3<f64>, axis: Vector3<f64>, radius: f64) -> Self {
        let up = normal - axis * normal.dot(&axis);
        let upright = up.norm();
        let ahead = axis.cross(&normal) / upright;
        let reach = clearance / upright;
        Self {
            ahead,
            left: normal.cross(&ahead),
            normal,
            arm: up * (-reach / upright),
            deflection: radius - reach,
            upright,
        }
    }

    /// The rate of the deflection, of the velocity that the carrier has at the contact point over the road.
    pub fn deflection_rate(&self, velocity: &Vector3<f64>) -> f64 {
        -self.normal.dot(velocity) / self.upright
    }

    /// The force along the normal of a load in the wheel's plane, whose work is that of the deflection.
    pub fn along_normal(&self, load: f64) -> Vector3<f64> {
        self.normal * (load / self.upright)
    }
}
