//! The wheels of a listing, and the vehicle data of a motion file.

use std::f64::consts::TAU;
use std::rc::Rc;

use nalgebra::Vector3;
use suspension_core::listing::WheelPlaces;

use crate::file::{Axle, Torque};
use crate::mechanism::parts::mass::Mass;
use crate::mechanism::parts::spring::Spring;

/// The data that quantities need besides the linkage.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Vehicle {
    /// The numbers of the drives that move wheels up and down, each once.
    pub travel: Vec<usize>,
    /// The numbers of the drives that steer them, each once.
    pub steer: Vec<usize>,
    /// The steering wheel, if it is known how far it moves the drive of steering.
    pub steering_wheel: Option<SteeringWheel>,
    /// The distance between the axles, in the unit of lengths.
    pub wheelbase: Option<f64>,
    /// The height of the centre of gravity above the ground, in the unit of lengths.
    pub cg_height: Option<f64>,
    /// Springs and anti-roll bars.
    pub springs: Rc<[Spring]>,
    /// Parts that have a mass.
    pub masses: Rc<[Mass]>,
}

impl Vehicle {
    /// Whether a drive moves or steers a wheel.
    pub(crate) fn is_moved_by(&self, drive: usize) -> bool {
        self.travel.contains(&drive) || self.steer.contains(&drive)
    }
}

/// A steering wheel that moves a drive in proportion, as a rack and pinion or a steering box does.
#[derive(Clone, Debug, PartialEq)]
pub struct SteeringWheel {
    /// The number of the drive.
    pub drive: usize,
    /// The numbers of the wheels that the drive turns at the design position.
    pub turned: Vec<usize>,
    /// The change of the drive per turn to the left, in the unit of lengths or in radians: negative if a decrease of
    /// the drive turns the wheels to the left at the design position.
    pub per_turn: f64,
    /// The drive's value at the design position, in the file's coordinates.
    pub design: f64,
}

impl SteeringWheel {
    /// The line of a motion file that tells how far it moves a rack.
    pub const RACK: &str = "rack_per_turn";
    /// The line of a motion file for a steering box, whose drive is an angle.
    pub(crate) const BOX: &str = "steering_box_ratio";

    /// The angle by which it turns per unit of the drive, in radians, positive to the left.
    pub fn per_drive(&self) -> f64 {
        TAU / self.per_turn
    }

    /// The angle by which it is turned from the design position, for these values of all drives.
    pub fn angle(&self, drives: &[f64]) -> f64 {
        (drives[self.drive] - self.design) * self.per_drive()
    }
}

/// A wheel that a listing states, with its data in the motion file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Wheel {
    /// Its name; empty for a single wheel that is stated without one.
    pub name: String,
    /// Its points.
    pub points: WheelPoints,
    /// The number of the drive that moves it up and down.
    pub travel: Option<usize>,
    /// If no such drive is known: the drives that lift it at the design position.
    pub lifted_by: Vec<usize>,
    /// The number of the drive that steers it.
    pub steer: Option<usize>,
    /// The distance from its centre to the ground, in the unit of lengths.
    pub radius: Option<f64>,
    /// The axle of a car to which it belongs.
    pub axle: Option<Axle>,
    /// The axle's share of the brake force.
    pub brake_share: Option<f64>,
    /// The axle's share of the drive force.
    pub drive_share: Option<f64>,
    /// The part that bears its brake torque.
    pub brake_torque: Torque,
    /// The part that bears its drive torque.
    pub drive_torque: Torque,
    /// The points of its axis at the design position, in local coordinates; `None` for a listing without points.
    pub design: Option<[Vector3<f64>; 2]>,
    /// Whether it is then in the middle of the vehicle, like a motorcycle's wheel.
    pub is_in_middle: bool,
    /// The coupling of its travel with that of other wheels.
    pub coupling: Coupling,
}

/// The coupling of a wheel's travel with that of others at the design position, with the other wheel of its axle held
/// at its height.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Coupling {
    /// Its travel moves the carrier of another wheel, as in a twist beam.
    pub moves_another: bool,
    /// The travel of another wheel moves its carrier.
    pub is_moved: bool,
    /// Its travel requires the drives of both wheels of its axle: either one moves both wheels up or down, for
    /// example if both dampers of a rigid axle drive it.
    pub takes_both_drives: bool,
}

impl Coupling {
    /// Whether its travel moves another wheel, or is moved by one.
    pub(crate) fn is_coupled(self) -> bool {
        self.moves_another || self.is_moved
    }
}

/// The points of a wheel, by number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WheelPoints {
    /// The two points on the spin axis, pointing outboard: the inner point and the wheel centre.
    pub axis: [usize; 2],
    /// Three points of the body that carries the wheel.
    pub carrier: [usize; 3],
    /// The kingpin's lower and upper point, if the listing states one.
    pub kingpin: Option<[usize; 2]>,
}

impl Wheel {
    /// A word followed by the wheel's name, as in a listing: `wheel left`.
    pub fn stated(&self, word: &str) -> String {
        format!("{word} {}", self.name).trim_end().to_owned()
    }

    /// Its name for people: `left wheel`.
    pub fn title(&self, what: &str) -> String {
        format!("{} {what}", self.name).trim_start().to_owned()
    }

    /// Whether both are on one side of the vehicle, according to the direction in which their axes point at the
    /// design position: two such wheels are dual wheels or one behind the other, and not an axle.
    pub(crate) fn is_on_the_side_of(&self, other: &Self) -> bool {
        let outboard = |wheel: &Self| wheel.design.map(|[inner, centre]| centre.y - inner.y);
        let both = outboard(self).zip(outboard(other));
        both.is_some_and(|(one, other)| one * other > 0.0)
    }

    /// Whether the body that carries the wheel of this number carries another one on the other side of the vehicle, like
    /// a live axle.
    pub(crate) fn shares_its_carrier(wheels: &[Self], number: usize) -> bool {
        let own = &wheels[number];
        let mut others = wheels.iter().enumerate();
        others.any(|(other, wheel)| {
            let is_on_one_body = wheel.points.carrier == own.points.carrier;
            other != number && is_on_one_body && !wheel.is_on_the_side_of(own)
        })
    }

    pub(crate) fn places(&self) -> WheelPlaces<'_> {
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
            ..Self::default()
        }
    }
}
