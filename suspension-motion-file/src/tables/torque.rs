//! The part that bears the torque of a wheel.

use serde::Deserialize;

use crate::tables::per_wheel::OfWheel;

/// The part that bears the torque of brakes or of the drive. It determines the point at which their force acts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Torque {
    /// The wheel's carrier, as with outboard brakes, motors in the wheels, and an axle with the differential in it: the
    /// force acts at the contact point.
    #[default]
    Carrier,
    /// The chassis, by shafts, as with a differential or brakes on the chassis: the force acts at the wheel centre.
    Chassis,
}

impl OfWheel for Torque {
    const WRITTEN: &str =
        "\"carrier\" or \"chassis\", or { front = \"chassis\", rear = \"carrier\" }";
}
