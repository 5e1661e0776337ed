//! How drives enter, and the quantities computed from the points, as indices.

use suspension_core::listing::{DriveKind, MeasureKind, WheelPlaces};
use suspension_listing::name::Name;
use suspension_listing::system::{self, Quantity, System};

use super::places::{distance, point, turn};
use crate::table::index;

/// How a drive enters the equations.
#[derive(Clone, Debug)]
pub(crate) struct Drive {
    pub(crate) quantity: Measure,
    /// The distance, or the angle about an axis, whose length converts an angle to a coordinate.
    pub(crate) angle_of: Option<u16>,
    /// The chassis point that it moves.
    pub(crate) moves: Option<u16>,
}

/// A quantity that is read from the points.
#[derive(Clone, Debug)]
pub(crate) enum Measure {
    /// A sum of coordinates.
    Sum(Vec<Coordinate>),
    /// The angle of a line from an axis.
    Angle { axis: u16, line: [u16; 2] },
    /// The angle between two lines, seen along a third one if there is one.
    Between {
        lines: [[u16; 2]; 2],
        about: Option<[u16; 2]>,
    },
    /// The distance between two points.
    Length { line: [u16; 2] },
    /// The coordinate of a point along a unit vector.
    Along { point: u16, direction: [f64; 3] },
}

/// A coordinate of a point, times a factor.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Coordinate {
    pub(crate) factor: f64,
    pub(crate) point: u16,
    pub(crate) axis: u16,
}

/// The points of a wheel and of its kingpin.
#[derive(Clone, Debug)]
pub(crate) struct Wheel {
    /// Empty if the listing states none.
    pub(crate) name: String,
    pub(crate) axis: [u16; 2],
    pub(crate) carrier: [u16; 3],
    pub(crate) kingpin: Option<[u16; 2]>,
}

impl Measure {
    fn new(system: &System, quantity: &Quantity) -> Self {
        let point = |name| point(system, name);
        match quantity {
            Quantity::Sum(terms) => Self::Sum(
                (terms.iter())
                    .map(|term| Coordinate {
                        factor: term.factor,
                        point: point(&term.point),
                        axis: index(term.axis),
                    })
                    .collect(),
            ),
            Quantity::Angle { axis, line } => Self::Angle {
                axis: index(*axis),
                line: line.each_ref().map(point),
            },
            Quantity::Between { lines, about } => Self::Between {
                lines: lines.each_ref().map(|line| line.each_ref().map(point)),
                about: about.as_ref().map(|line| line.each_ref().map(point)),
            },
            Quantity::Length { line } => Self::Length {
                line: line.each_ref().map(point),
            },
            Quantity::Along {
                point: of,
                direction,
            } => Self::Along {
                point: point(of),
                direction: *direction,
            },
        }
    }

    pub(crate) fn drive_kind(&self) -> DriveKind {
        match self {
            Self::Angle { .. } => DriveKind::Angle,
            Self::Between { .. } => DriveKind::Turn,
            _ => DriveKind::Coordinate,
        }
    }

    pub(crate) fn measure_kind(&self) -> MeasureKind {
        match self {
            Self::Angle { .. } | Self::Between { .. } => MeasureKind::Angle,
            _ => MeasureKind::Length,
        }
    }
}

impl Wheel {
    pub(crate) fn places(&self) -> WheelPlaces<'_> {
        WheelPlaces {
            name: &self.name,
            axis: self.axis.map(usize::from),
            carrier: self.carrier.map(usize::from),
            kingpin: self.kingpin.map(|ends| ends.map(usize::from)),
        }
    }
}

pub(super) fn wheels(system: &System) -> Vec<Wheel> {
    let point = |name: &Name| point(system, name);
    let wheel = |wheel: &system::Wheel| Wheel {
        name: wheel
            .name
            .as_ref()
            .map_or_else(String::new, ToString::to_string),
        axis: wheel.axis.each_ref().map(point),
        carrier: wheel.carrier.each_ref().map(point),
        kingpin: wheel
            .kingpin
            .as_ref()
            .map(|ends| ends.each_ref().map(point)),
    };
    system.wheels.iter().map(wheel).collect()
}

pub(super) fn drives(system: &System) -> Vec<Drive> {
    let drive = |drive: &system::Drive| Drive {
        quantity: Measure::new(system, &drive.quantity),
        angle_of: (drive.angle_of.as_ref()).map(|name| match drive.quantity {
            Quantity::Between { .. } => turn(system, name),
            _ => distance(system, name),
        }),
        moves: drive.moves.as_ref().map(|site| index(site.index)),
    };
    system.drives.iter().map(drive).collect()
}

pub(super) fn measures(system: &System) -> Vec<Measure> {
    let measures = system.measures.iter();
    measures
        .map(|measure| Measure::new(system, &measure.quantity))
        .collect()
}
