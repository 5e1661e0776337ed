//! The wheel on flat ground: its contact point and its heading.

use nalgebra::Vector3;

use crate::signal::Number;
use crate::wheel::angles::opposite_on_the_right;

/// The contact point with flat, level ground: the lowest point of the circle of `radius` about the wheel centre in
/// the plane normal to the spin axis. Not finite if the spin axis is vertical.
pub fn contact<N: Number>(centre: &Vector3<N>, spin_axis: &Vector3<N>, radius: N) -> Vector3<N> {
    let (radial, length) = upward_radius(spin_axis);
    centre - radial * (radius / length)
}

/// The velocity of the [`contact`] point along its path, given the velocity of the wheel centre and the rate of the
/// vector `spin_axis`, whatever its length.
pub fn contact_velocity<N: Number>(
    centre_velocity: &Vector3<N>,
    spin_axis: &Vector3<N>,
    axis_rate: &Vector3<N>,
    radius: N,
) -> Vector3<N> {
    let (radial, length) = upward_radius(spin_axis);
    let unit = radial / length;
    let square = spin_axis.dot(spin_axis);
    let rate = -(axis_rate * spin_axis.z + spin_axis * axis_rate.z) / square;
    centre_velocity - (rate - unit * unit.dot(&rate)) * (radius / length)
}

/// The vertical unit vector minus its component along the spin axis: upwards in the plane of the wheel. Also its length.
fn upward_radius<N: Number>(spin_axis: &Vector3<N>) -> (Vector3<N>, N) {
    let up = Vector3::new(N::zero(), N::zero(), N::one());
    let radial = up - spin_axis * (spin_axis.z / spin_axis.dot(spin_axis));
    (radial, radial.dot(&radial).square_root())
}

/// Horizontal directions of a wheel, of unit length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Heading<N> {
    /// The direction in which the wheel rolls when the vehicle drives forward.
    pub forward: Vector3<N>,
    /// Away from the vehicle, normal to [`forward`](Self::forward).
    pub outboard: Vector3<N>,
}

impl<N: Number> Heading<N> {
    /// Computes the directions from a spin axis that points outboard; not finite if it is vertical.
    pub fn of(spin_axis: &Vector3<N>) -> Self {
        let level = Vector3::new(spin_axis.x, spin_axis.y, N::zero());
        let outboard = level / level.dot(&level).square_root();
        let ahead = Vector3::new(outboard.y, -outboard.x, N::zero());
        let forward = opposite_on_the_right(spin_axis, ahead);
        Self { forward, outboard }
    }
}
