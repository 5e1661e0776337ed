//! Angles of the spin axis and of the steering axis.

use nalgebra::Vector3;

use crate::signal::Number;

/// Camber, positive where the top of the wheel leans outboard: the angle in the y-z plane between
/// the spin axis and the y axis, `atan2(-s_z, |s_y|)`.
///
/// Another definition in use (Adams/Car) is `asin` of the axis' vertical part,
/// [`camber_to_ground`]; the two differ where the wheel is steered.
pub fn camber<N: Number>(spin_axis: &Vector3<N>) -> N {
    N::arc_tangent(-spin_axis.z, spin_axis.y.magnitude())
}

/// Camber as the angle between the spin axis and the ground, `asin(-s_z / |s|)`, positive where
/// the top of the wheel leans outboard.
pub fn camber_to_ground<N: Number>(spin_axis: &Vector3<N>) -> N {
    let level = spin_axis.x * spin_axis.x + spin_axis.y * spin_axis.y;
    N::arc_tangent(-spin_axis.z, level.square_root())
}

/// Toe, positive where the front of the wheel points inboard (toe-in): `atan2(s_x, |s_y|)`.
pub fn toe<N: Number>(spin_axis: &Vector3<N>) -> N {
    N::arc_tangent(spin_axis.x, spin_axis.y.magnitude())
}

/// Kingpin angle (inclination), positive where the top of the kingpin leans inboard: its angle in
/// the y-z plane from the vertical, `atan2(-k_y, k_z)` on the left. `kingpin` points upwards.
pub fn kingpin_angle<N: Number>(kingpin: &Vector3<N>, spin_axis: &Vector3<N>) -> N {
    let outboard = if spin_axis.y.is_below_zero() {
        -kingpin.y
    } else {
        kingpin.y
    };
    N::arc_tangent(-outboard, kingpin.z)
}

/// Caster, positive where the top of the kingpin leans rearwards: its angle in the x-z plane from
/// the vertical, `atan2(-k_x, k_z)`. `kingpin` points upwards.
pub fn caster<N: Number>(kingpin: &Vector3<N>) -> N {
    N::arc_tangent(-kingpin.x, kingpin.z)
}
