//! The wheel on flat ground: its contact point and its heading.

use nalgebra::Vector3;

use crate::signal::Number;

/// The contact point with flat, level ground: the lowest point of the circle of `radius` about the wheel centre in
/// the plane normal to the spin axis. Not finite if the spin axis is vertical.
pub fn contact<N: Number>(centre: &Vector3<N>, spin_axis: &Vector3<N>, radius: N) -> Vector3<N> {
    let up = Vector3::new(N::zero(), N::zero(), N::one());
    let square = spin_axis.dot(spin_axis);
    // The vertical minus its component along the axis.
    let radial = up - spin_axis * (spin_axis.z / square);
    let length = radial.dot(&radial).square_root();
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
    let up = Vector3::new(N::zero(), N::zero(), N::one());
    let square = spin_axis.dot(spin_axis);
    let radial = up - spin_axis * (spin_axis.z / square);
    let length = radial.dot(&radial).square_root();
    let unit = radial / length;
    let rate = -(axis_rate * spin_axis.z + spin_axis * axis_rate.z) / square;
    centre_velocity - (rate - unit * unit.dot(&rate)) * (radius / length)
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
        let forward = if spin_axis.y.is_below_zero() {
            -ahead
        } else {
            ahead
        };
        Self { forward, outboard }
    }
}
