//! The wheels of a listing, and what a motion file says of their vehicle.

use serde::Deserialize;
use suspension_core::WheelPlaces;

/// What quantities need beside the linkage.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Vehicle {
    /// From each wheel centre to the ground, in the unit of lengths.
    pub wheel_radius: Option<f64>,
    /// The numbers of the drives that move wheels up and down, each once.
    pub travel: Vec<usize>,
    /// The numbers of the drives that steer them, likewise.
    pub steer: Vec<usize>,
    /// From axle to axle, in the unit of lengths.
    pub wheelbase: Option<f64>,
    /// The car that the wheels are of; the wheelbase is then known.
    pub car: Option<Car>,
}

impl Vehicle {
    /// Whether a drive moves or steers a wheel.
    pub fn is_moved_by(&self, drive: usize) -> bool {
        self.travel.contains(&drive) || self.steer.contains(&drive)
    }
}

/// What a car's braking and driving make of a wheel's support angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Car {
    /// Which axle the wheel is on.
    pub axle: Axle,
    /// The height of the centre of gravity above the ground, in the unit of lengths.
    pub cg_height: f64,
    /// The axle's share of the brake force.
    pub brake_share: Option<f64>,
    /// The axle's share of the drive force.
    pub drive_share: Option<f64>,
}

/// An axle of a car.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Axle {
    /// The leading one.
    Front,
    /// The trailing one.
    Rear,
}

/// A wheel that a listing states.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wheel {
    /// Its name; empty of an only wheel that is stated without one.
    pub name: String,
    /// Its points.
    pub points: WheelPoints,
    /// The number of the drive that moves it up and down.
    pub travel: Option<usize>,
    /// The number of the drive that steers it.
    pub steer: Option<usize>,
}

/// The points of a wheel, by number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WheelPoints {
    /// On the spin axis, pointing outboard: the inner one and the wheel centre.
    pub axis: [usize; 2],
    /// Of the body that carries the wheel.
    pub carrier: [usize; 3],
    /// The kingpin's lower and upper point, where the listing states one.
    pub kingpin: Option<[usize; 2]>,
}

impl Wheel {
    /// A word with the wheel's name behind it, as a listing has it: `wheel left`.
    pub fn stated(&self, word: &str) -> String {
        format!("{word} {}", self.name).trim_end().to_owned()
    }

    /// What it is called: `left wheel`.
    pub fn title(&self, what: &str) -> String {
        format!("{} {what}", self.name).trim_start().to_owned()
    }

    pub(super) fn places(&self) -> WheelPlaces<'_> {
        WheelPlaces {
            name: &self.name,
            axis: self.points.axis,
            carrier: self.points.carrier,
            kingpin: self.points.kingpin,
        }
    }
}

impl From<WheelPlaces<'_>> for Wheel {
    fn from(places: WheelPlaces<'_>) -> Self {
        Self {
            name: places.name.to_owned(),
            points: WheelPoints {
                axis: places.axis,
                carrier: places.carrier,
                kingpin: places.kingpin,
            },
            travel: None,
            steer: None,
        }
    }
}
