//! The vehicle data of a file, in addition to the linkage.

use serde::Deserialize;
use toml::Spanned;

use crate::tables::per_wheel::PerWheel;
use crate::tables::several_notations::written_as_table;
use crate::{Axle, Torque};

/// Data that quantities need in addition to the linkage.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, remote = "Self")]
pub struct VehicleTable {
    /// The height of the wheel centre above the ground, in the unit of lengths.
    pub wheel_radius: Option<Spanned<PerWheel<f64>>>,
    /// The drive that moves each wheel up and down.
    pub travel: Option<Spanned<PerWheel<String>>>,
    /// The drive that steers each wheel.
    pub steer: Option<Spanned<PerWheel<String>>>,
    /// The travel of that drive per turn of the steering wheel, in the unit of lengths.
    pub rack_per_turn: Option<Spanned<f64>>,
    /// If that drive is an angle: the angle of the steering wheel per angle of the drive.
    pub steering_box_ratio: Option<Spanned<f64>>,
    /// The axle of the wheels, if their names do not state it.
    pub axle: Option<Axle>,
    /// The distance between the axles, in the unit of lengths.
    pub wheelbase: Option<Spanned<f64>>,
    /// The height of the centre of gravity above the ground, in the unit of lengths.
    pub cg_height: Option<Spanned<f64>>,
    /// The axle's share of the brake force, from 0 to 1.
    pub brake_share: Option<Spanned<PerWheel<f64>>>,
    /// The axle's share of the drive force, from 0 to 1.
    pub drive_share: Option<Spanned<PerWheel<f64>>>,
    /// The part that bears the torque of the brakes; by default the carriers.
    pub brake_torque: Option<Spanned<PerWheel<Torque>>>,
    /// The part that bears the torque of the drive; by default the chassis, or the body that carries both wheels.
    pub drive_torque: Option<Spanned<PerWheel<Torque>>>,
}

written_as_table!(VehicleTable, "lines under [vehicle], as wheel_radius = 0.3");

impl VehicleTable {
    /// The table of a file that has none.
    pub(crate) fn left_out() -> Spanned<Self> {
        Spanned::new(0..0, Self::default())
    }
}
