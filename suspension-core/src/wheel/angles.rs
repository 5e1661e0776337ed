//! Angles of the spin axis and of the steering axis.

use core::ops::Neg;

use nalgebra::Vector3;

use crate::signal::Number;

/// Camber, positive where the top of the wheel leans outboard: the angle in the y-z plane between
/// the spin axis and the y axis, `atan2(-s_z, |s_y|)`.
///
/// Another definition in use (Adams/Car) is the `asin` of the axis's vertical component, [`camber_to_ground`]; the
/// two differ if the wheel is steered.
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
    N::arc_tangent(-opposite_on_the_right(spin_axis, kingpin.y), kingpin.z)
}

/// Caster, positive where the top of the kingpin leans rearwards: its angle in the x-z plane from
/// the vertical, `atan2(-k_x, k_z)`. `kingpin` points upwards.
pub fn caster<N: Number>(kingpin: &Vector3<N>) -> N {
    N::arc_tangent(-kingpin.x, kingpin.z)
}

/// Steer angle, positive where the wheel points to the left: [`toe`] on the right, negative [`toe`] on the left. ISO
/// 8855.
pub fn steer_angle<N: Number>(spin_axis: &Vector3<N>) -> N {
    positive_to_the_left(toe(spin_axis), spin_axis)
}

/// The rate of [`camber`] when the spin axis changes at a rate.
pub fn camber_rate<N: Number>(spin_axis: &Vector3<N>, rate: &Vector3<N>) -> N {
    let outboard = outboard(spin_axis);
    arc_tangent_rate(
        [-spin_axis.z, spin_axis.y * outboard],
        [-rate.z, rate.y * outboard],
    )
}

/// The rate of [`steer_angle`] when the spin axis changes at a rate.
pub fn steer_rate<N: Number>(spin_axis: &Vector3<N>, rate: &Vector3<N>) -> N {
    let outboard = outboard(spin_axis);
    let of_toe = arc_tangent_rate(
        [spin_axis.x, spin_axis.y * outboard],
        [rate.x, rate.y * outboard],
    );
    positive_to_the_left(of_toe, spin_axis)
}

/// 1 for a wheel on the left, -1 on the right.
fn outboard<N: Number>(spin_axis: &Vector3<N>) -> N {
    opposite_on_the_right(spin_axis, N::one())
}

/// The quantity itself for a wheel on the left, its opposite for one on the right: turns a quantity that counts to the left
/// into one that counts outboard, and the reverse.
pub(super) fn opposite_on_the_right<N: Number, V: Neg<Output = V>>(
    spin_axis: &Vector3<N>,
    quantity: V,
) -> V {
    if spin_axis.y.is_below_zero() {
        -quantity
    } else {
        quantity
    }
}

/// Converts an angle that is positive inboard to one that is positive to the left.
fn positive_to_the_left<N: Number>(inboard: N, spin_axis: &Vector3<N>) -> N {
    -inboard * outboard(spin_axis)
}

/// The rate of the angle of the direction `(x, y)` from the x axis.
pub(super) fn arc_tangent_rate<N: Number>([y, x]: [N; 2], [y_rate, x_rate]: [N; 2]) -> N {
    (y_rate * x - y * x_rate) / (x * x + y * y)
}
