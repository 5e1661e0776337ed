//! The vehicle data of a file, in addition to the linkage.

use serde::Deserialize;
use toml::Spanned;

use crate::per_wheel::PerWheel;
use crate::{Axle, Torque};

/// What quantities need beside the linkage.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct VehicleTable {
    /// From the wheel centre to the ground, in the unit.
    pub wheel_radius: Option<Spanned<PerWheel<f64>>>,
    /// The drive that moves each wheel up and down.
    pub travel: Option<Spanned<PerWheel<String>>>,
    /// The drive that steers it.
    pub steer: Option<Spanned<PerWheel<String>>>,
    /// How far that drive moves in a turn of the steering wheel, in the unit.
    pub rack_per_turn: Option<Spanned<f64>>,
    /// Of a drive that is an angle: how far the steering wheel turns for it.
    pub steering_box_ratio: Option<Spanned<f64>>,
    /// Which axle the wheels are on, where their names do not tell.
    pub axle: Option<Axle>,
    /// From axle to axle, in the unit.
    pub wheelbase: Option<Spanned<f64>>,
    /// The height of the centre of gravity above the ground, in the unit.
    pub cg_height: Option<Spanned<f64>>,
    /// The axle's share of the brake force, from 0 to 1.
    pub brake_share: Option<Spanned<PerWheel<f64>>>,
    /// The axle's share of the drive force, from 0 to 1.
    pub drive_share: Option<Spanned<PerWheel<f64>>>,
    /// What bears the torque of the brakes; left out, the carriers.
    pub brake_torque: Option<Spanned<PerWheel<Torque>>>,
    /// What bears the torque of the drive; left out, the chassis, or the body that carries both wheels.
    pub drive_torque: Option<Spanned<PerWheel<Torque>>>,
}
