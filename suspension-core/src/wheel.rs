//! What engineers read off a wheel. Signs, units and definitions live here and nowhere else.
//!
//! Axes are those of ISO 8855: x forward, y to the left, z up. Angles are in radians, computed by
//! `atan2`, and signed so that they mean the same on both sides of a vehicle: the side is that of
//! the wheel's spin axis, which points outboard, from the first point of `wheel:` to the centre.

use nalgebra::Vector3;

use crate::body;
use crate::scalar::Real;
use crate::signal::Signal;

/// Camber, positive where the top of the wheel leans outboard: the angle in the y-z plane between
/// the spin axis and the y axis, `atan2(-s_z, |s_y|)`.
///
/// Another definition in use (Adams/Car) is `asin` of the axis' vertical part,
/// [`camber_to_ground`]; the two differ where the wheel is steered.
pub fn camber<T: Real>(spin_axis: &Vector3<T>) -> T {
    (-spin_axis.z).atan2(spin_axis.y.abs())
}

/// Camber as the angle between the spin axis and the ground, `asin(-s_z / |s|)`, positive where
/// the top of the wheel leans outboard.
pub fn camber_to_ground<T: Real>(spin_axis: &Vector3<T>) -> T {
    let level = (spin_axis.x * spin_axis.x + spin_axis.y * spin_axis.y).sqrt();
    (-spin_axis.z).atan2(level)
}

/// Toe, positive where the front of the wheel points inboard (toe-in): `atan2(s_x, |s_y|)`.
pub fn toe<T: Real>(spin_axis: &Vector3<T>) -> T {
    spin_axis.x.atan2(spin_axis.y.abs())
}

/// Kingpin angle (inclination), positive where the top of the kingpin leans inboard: its angle in
/// the y-z plane from the vertical, `atan2(-k_y, k_z)` on the left. `kingpin` points upwards.
pub fn kingpin_angle<T: Real>(kingpin: &Vector3<T>, spin_axis: &Vector3<T>) -> T {
    let outboard = if spin_axis.y < T::zero() {
        -kingpin.y
    } else {
        kingpin.y
    };
    (-outboard).atan2(kingpin.z)
}

/// Caster, positive where the top of the kingpin leans rearwards: its angle in the x-z plane from
/// the vertical, `atan2(-k_x, k_z)`. `kingpin` points upwards.
pub fn caster<T: Real>(kingpin: &Vector3<T>) -> T {
    (-kingpin.x).atan2(kingpin.z)
}

/// A wheel spinning about its axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spin<T> {
    /// rad/s about the spin axis, right-handed about the outboard direction.
    pub rate: T,
    /// rad/s^2.
    pub second_rate: T,
}

/// Angular velocity of the wheel, rad/s: the carrier's plus the spin.
pub fn wheel_angular_velocity<T: Real>(
    carrier: &Vector3<T>,
    unit_axis: &Vector3<T>,
    spin: &Spin<T>,
) -> Vector3<T> {
    carrier + unit_axis * spin.rate
}

/// Angular acceleration of the wheel, rad/s^2: the carrier's, the spin's, and that of the axis
/// being swung round, `omega x s rate`.
pub fn wheel_angular_acceleration<T: Real>(
    carrier: &Vector3<T>,
    carrier_velocity: &Vector3<T>,
    unit_axis: &Vector3<T>,
    spin: &Spin<T>,
) -> Vector3<T> {
    carrier + unit_axis * spin.second_rate + carrier_velocity.cross(unit_axis) * spin.rate
}

/// The wheel and its carrier in one configuration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheel<T> {
    /// Wheel centre, in the unit of the hardpoints.
    pub centre: Vector3<T>,
    /// Spin axis, of unit length, outboard.
    pub axis: Vector3<T>,
    /// See [`camber`].
    pub camber: T,
    /// See [`toe`].
    pub toe: T,
}

impl<T: Real> Wheel<T> {
    /// Reads the wheel off two points on its spin axis, the wheel centre last
    /// ([`Linkage::wheel_axis`](crate::Linkage::wheel_axis)); `None` where they coincide.
    pub fn of([inner, centre]: [Vector3<T>; 2]) -> Option<Self> {
        let axis = centre - inner;
        let length = axis.norm();
        let axis = (length > T::zero() && length.is_finite()).then(|| axis / length)?;
        Some(Self {
            centre,
            axis,
            camber: camber(&axis),
            toe: toe(&axis),
        })
    }
}

/// The kingpin in one configuration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kingpin<T> {
    /// See [`kingpin_angle`].
    pub angle: T,
    /// See [`caster`].
    pub caster: T,
}

impl<T: Real> Kingpin<T> {
    /// Reads the kingpin off its ends ([`Linkage::kingpin`](crate::Linkage::kingpin)) and those of the
    /// wheel's spin axis, which say what is outboard.
    pub fn of([lower, upper]: [Vector3<T>; 2], [inner, centre]: [Vector3<T>; 2]) -> Self {
        let kingpin = upper - lower;
        Self {
            angle: kingpin_angle(&kingpin, &(centre - inner)),
            caster: caster(&kingpin),
        }
    }
}

/// How the body that carries the wheel turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarrierRotation<T> {
    /// Angular velocity, rad/s.
    pub omega: Vector3<T>,
    /// Angular acceleration, rad/s^2.
    pub alpha: Vector3<T>,
}

impl<T: Real> CarrierRotation<T> {
    /// From positions, velocities and accelerations of three points of the body
    /// ([`Linkage::wheel_carrier`](crate::Linkage::wheel_carrier)); `None` where they are in line.
    pub fn of(points: &Signal<[Vector3<T>; 3]>) -> Option<Self> {
        let at = &points.value;
        let omega = body::angular_velocity(at, &points.rate)?;
        let alpha = body::angular_acceleration(at, &omega, &points.second_rate)?;
        Some(Self { omega, alpha })
    }
}
