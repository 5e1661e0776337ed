//! Wheel quantities. Their signs, units and definitions are here and nowhere else.
//!
//! Formulas take real numbers or [`Signal`]s of them. With signals they give derivatives too: with respect to time
//! from positions, velocities and accelerations, with respect to a drive from the results of
//! [`Corner::per`](crate::Corner::per).
//!
//! Camber gain and bump steer of a corner, and the rate of camber while it moves:
//!
//! ```
//! use suspension_core::linkages::double_wishbone::{Corner, Drives};
//! use suspension_core::Signal;
//!
//! let mut corner: Corner = Corner::design()?;
//! let (start, rate) = (corner.drives(), Drives { bump: 0.05, steer: 0.0 });
//! corner.advance(0.5, |time| Signal::line(start, rate, time))?;
//! let per_bump = corner.per(Drives { bump: 1.0, steer: 0.0 })?;
//! let gain = corner.wheel_rates(&per_bump.points).ok_or("no wheel")?.rate; // rad/m
//! let moving = corner.wheel_rates(&corner.points()).ok_or("no wheel")?;
//! assert!((moving.rate.camber - gain.camber * rate.bump).abs() < 1e-15); // rad/s
//! let [camber, bump_steer] = [gain.camber, gain.toe].map(f64::to_degrees);
//! assert_eq!(format!("{camber:.2} and {bump_steer:.2} deg/m"), "-17.55 and -5.00 deg/m");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Axes are those of ISO 8855: x forward, y to the left, z up. Angles are in radians, computed by
//! `atan2`. Their signs mean the same on both sides of a vehicle. The side is taken from
//! the wheel's spin axis, which points outboard, from the first point of `wheel:` to the centre.

mod angles;
mod axle;
mod ground;
mod steering;
mod travel;

use nalgebra::Vector3;

use crate::arithmetic::scalar::Real;
use crate::body;
use crate::signal::{Number, Signal};

pub use angles::{
    camber, camber_rate, camber_to_ground, caster, kingpin_angle, steer_angle, steer_rate, toe,
};
pub use axle::{Turn, roll_centre, roll_rate};
pub use ground::{Heading, contact, contact_velocity};
pub use steering::SteeringAxis;
pub use travel::{Carrier, InstantCentre};

/// A wheel spinning about its axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spin<T> {
    /// Spin rate about the spin axis, rad/s, right-handed about the outboard direction.
    pub rate: T,
    /// Rate of the spin rate, rad/s^2.
    pub second_rate: T,
}

/// Angular velocity of the wheel, rad/s, from that of its carrier: the carrier's plus the spin about the unit vector of
/// the outboard spin axis.
pub fn wheel_angular_velocity<T: Real>(
    carrier_omega: &Vector3<T>,
    unit_axis: &Vector3<T>,
    spin: &Spin<T>,
) -> Vector3<T> {
    carrier_omega + unit_axis * spin.rate
}

/// Angular acceleration of the wheel, rad/s^2, from angular acceleration and velocity of its carrier: the carrier's,
/// that of the spin, and `omega x axis` times the spin rate, because the carrier turns the axis.
pub fn wheel_angular_acceleration<T: Real>(
    carrier_alpha: &Vector3<T>,
    carrier_omega: &Vector3<T>,
    unit_axis: &Vector3<T>,
    spin: &Spin<T>,
) -> Vector3<T> {
    carrier_alpha + unit_axis * spin.second_rate + carrier_omega.cross(unit_axis) * spin.rate
}

/// The wheel and its carrier in one configuration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheel<T> {
    /// Wheel centre, in the unit of the hardpoints.
    pub centre: Vector3<T>,
    /// Unit vector of the spin axis, pointing outboard.
    pub axis: Vector3<T>,
    /// See [`camber`].
    pub camber: T,
    /// See [`toe`].
    pub toe: T,
}

impl<T: Real> Wheel<T> {
    /// Reads the wheel from two points on its spin axis, the wheel centre last
    /// ([`Linkage::wheel_axis`](crate::Linkage::wheel_axis)); `None` if they coincide.
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

    /// Reads the wheel with its derivatives from these two points with theirs: `rate` and `second_rate` have the derivatives of each
    /// number, those of the unit vector too. `None` if the points coincide. A corner has them for its first wheel:
    /// [`Corner::wheel_rates`](crate::Corner::wheel_rates).
    pub fn with_rates(points: &Signal<[Vector3<T>; 2]>) -> Option<Signal<Self>> {
        let value = Self::of(points.value)?;
        let axis = points.map(|[inner, centre]| centre - inner).components();
        let (camber, toe) = (camber(&axis), toe(&axis));
        let unit = axis / axis.dot(&axis).square_root();
        let derivative = |[_, centre]: [Vector3<T>; 2], of: fn(&Signal<T>) -> T| Self {
            centre,
            axis: unit.map(|component| of(&component)),
            camber: of(&camber),
            toe: of(&toe),
        };
        Some(Signal {
            value,
            rate: derivative(points.rate, |number| number.rate),
            second_rate: derivative(points.second_rate, |number| number.second_rate),
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
    /// Reads the kingpin from its ends ([`Linkage::kingpin`](crate::Linkage::kingpin)) and from those of the wheel's
    /// spin axis, which tell the outboard direction.
    pub fn of([lower, upper]: [Vector3<T>; 2], [inner, centre]: [Vector3<T>; 2]) -> Self {
        let kingpin = upper - lower;
        Self {
            angle: kingpin_angle(&kingpin, &(centre - inner)),
            caster: caster(&kingpin),
        }
    }
}

/// The rotation of the body that carries the wheel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarrierRotation<T> {
    /// Angular velocity, rad/s.
    pub omega: Vector3<T>,
    /// Angular acceleration, rad/s^2.
    pub alpha: Vector3<T>,
}

impl<T: Real> CarrierRotation<T> {
    /// Computes the rotation from positions, velocities and accelerations of three points of the body
    /// ([`Linkage::wheel_carrier`](crate::Linkage::wheel_carrier)); `None` if they are collinear.
    pub fn of(points: &Signal<[Vector3<T>; 3]>) -> Option<Self> {
        let at = &points.value;
        let omega = body::angular_velocity(at, &points.rate)?;
        let alpha = body::angular_acceleration(at, &omega, &points.second_rate)?;
        Some(Self { omega, alpha })
    }
}
