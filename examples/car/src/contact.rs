//! The contact of a wheel with the plane of the road below it.

use nalgebra::Vector3;

/// A wheel over the plane of the road, in any axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Ahead in the wheel's plane and in the road's, of unit length.
    pub ahead: Vector3<f64>,
    /// To the left in the road's plane, of unit length.
    pub left: Vector3<f64>,
    /// Out of the road, of unit length.
    pub normal: Vector3<f64>,
    /// From the wheel centre to the contact point, in the wheel's plane, m.
    pub arm: Vector3<f64>,
    /// By what that is shorter than the tyre's radius, m; negative off the ground.
    pub deflection: f64,
    /// Cosine of the angle between the wheel's plane and the normal.
    pub upright: f64,
}

impl Contact {
    /// Of a wheel whose centre is a clearance above the road's plane, with its spin axis to the left and its unloaded radius.
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
