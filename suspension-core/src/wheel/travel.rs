//! How the carrier of a wheel moves in travel: instant centres and roll centre.

use nalgebra::Vector3;

use crate::signal::Number;
use crate::wheel::angles::opposite_on_the_right;

/// The carrier's velocity in travel, per unit of the drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carrier<N> {
    /// The wheel centre.
    pub centre: Vector3<N>,
    /// Its velocity.
    pub velocity: Vector3<N>,
    /// The angular velocity of the carrier.
    pub omega: Vector3<N>,
}

/// The instant centre of the carrier in a plane through the wheel centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InstantCentre<N> {
    /// Its horizontal coordinate: y in the front view, x in the side view.
    pub across: N,
    /// Its height.
    pub z: N,
    /// The swing arm: its horizontal distance from the wheel centre, positive inboard of the wheel centre in the
    /// front view and behind it in the side view.
    pub arm: N,
}

impl<N: Number> Carrier<N> {
    /// The velocity of a point that moves with the carrier.
    pub fn velocity_of(&self, point: &Vector3<N>) -> Vector3<N> {
        self.velocity + self.omega.cross(&(point - self.centre))
    }

    /// The instant centre in the plane x = constant through the wheel centre; not finite if the carrier moves
    /// parallel there. The spin axis points outboard.
    pub fn front_view(&self, spin_axis: &Vector3<N>) -> InstantCentre<N> {
        let to_the_right = self.velocity.z / self.omega.x;
        InstantCentre {
            across: self.centre.y - to_the_right,
            z: self.centre.z + self.velocity.y / self.omega.x,
            arm: opposite_on_the_right(spin_axis, to_the_right),
        }
    }

    /// The instant centre in the plane y = constant through the wheel centre; not finite if the carrier moves
    /// parallel there.
    pub fn side_view(&self) -> InstantCentre<N> {
        let arm = -(self.velocity.z / self.omega.y);
        InstantCentre {
            across: self.centre.x - arm,
            z: self.centre.z - self.velocity.x / self.omega.y,
            arm,
        }
    }

    /// The height of the roll centre of an axle whose other wheel mirrors this one in the plane y = 0: the point
    /// where the normal to the velocity of the carrier's point at the contact meets that plane, in the front view.
    pub fn roll_centre(&self, contact: &Vector3<N>) -> N {
        let velocity = self.velocity_of(contact);
        contact.z + contact.y * velocity.y / velocity.z
    }

    /// How far the carrier's point at the contact moves outboard per unit that it rises. The spin axis points
    /// outboard.
    pub fn outboard_slope(&self, contact: &Vector3<N>, spin_axis: &Vector3<N>) -> N {
        let velocity = self.velocity_of(contact);
        opposite_on_the_right(spin_axis, velocity.y / velocity.z)
    }
}
