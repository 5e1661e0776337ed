//! The axis about which a wheel steers, and its position relative to the wheel.

use nalgebra::Vector3;

use super::ground::Heading;
use crate::signal::Number;

/// A steering axis: the line through the ball joints of a kingpin, or the screw axis about which the carrier turns in
/// steering, which lies elsewhere if more than two links hold the wheel (the virtual steering axis).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteeringAxis<N> {
    /// A point on it.
    pub point: Vector3<N>,
    /// Its direction, upwards.
    pub direction: Vector3<N>,
}

impl<N: Number> SteeringAxis<N> {
    /// The line through two points, the lower one first.
    pub fn through([lower, upper]: [Vector3<N>; 2]) -> Self {
        Self {
            point: lower,
            direction: upper - lower,
        }
    }

    /// The screw axis of a body, from the velocity of one of its points and its angular velocity; not finite if the
    /// body does not turn. The velocities are those in steering, with the travel held as the listing's other drives
    /// hold it: at the height of the wheel, or by a damper's length.
    pub fn of_screw(at: &Vector3<N>, velocity: &Vector3<N>, omega: &Vector3<N>) -> Self {
        let square = omega.dot(omega);
        Self {
            point: at + omega.cross(velocity) / square,
            direction: if omega.z.is_below_zero() {
                -*omega
            } else {
                *omega
            },
        }
    }

    /// The point of the axis at a height.
    pub fn at_height(&self, z: N) -> Vector3<N> {
        self.point + self.direction * ((z - self.point.z) / self.direction.z)
    }

    /// How far the axis passes inboard of a point, at the point's height: the scrub radius (kingpin offset at ground)
    /// if the point is the contact point, the kingpin offset at the wheel centre if it is the wheel centre. ISO 8855.
    pub fn inboard_of(&self, point: &Vector3<N>, heading: &Heading<N>) -> N {
        (point - self.at_height(point.z)).dot(&heading.outboard)
    }

    /// How far the axis passes ahead of a point, at the point's height: the mechanical trail (caster offset at
    /// ground) if the point is the contact point, the caster offset at the wheel centre if it is the wheel centre.
    /// ISO 8855.
    pub fn ahead_of(&self, point: &Vector3<N>, heading: &Heading<N>) -> N {
        (self.at_height(point.z) - point).dot(&heading.forward)
    }
}
