//! How drives enter, and what is read off the points, as indices.

use suspension_core::{DriveKind, MeasureKind};
use suspension_listing::system::{self, Quantity, System};

use super::places::{distance, point};
use crate::table::index;

/// How a drive enters.
#[derive(Clone, Debug)]
pub(crate) struct Drive {
    pub(crate) quantity: Measure,
    /// The distance whose angle it is.
    pub(crate) angle_of: Option<u16>,
    /// The chassis point that it moves.
    pub(crate) moves: Option<u16>,
}

/// What is read off the points.
#[derive(Clone, Debug)]
pub(crate) enum Measure {
    /// A sum of coordinates.
    Sum(Vec<Coordinate>),
    /// The angle of a line from an axis.
    Angle { axis: u16, line: [u16; 2] },
    /// The angle between two lines, seen about a third one where there is one.
    Between {
        lines: [[u16; 2]; 2],
        about: Option<[u16; 2]>,
    },
    /// The distance of two points.
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

/// The points of wheel and kingpin, where the listing states them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Roles {
    pub(crate) wheel_axis: Option<[u16; 2]>,
    pub(crate) wheel_carrier: Option<[u16; 3]>,
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
            Self::Angle { .. } | Self::Between { .. } => DriveKind::Angle,
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

impl Roles {
    pub(super) fn new(system: &System) -> Self {
        let wheel = system.wheel.as_ref();
        let point = |name| point(system, name);
        Self {
            wheel_axis: wheel.map(|wheel| wheel.axis.each_ref().map(point)),
            wheel_carrier: wheel.map(|wheel| wheel.carrier.each_ref().map(point)),
            kingpin: system
                .kingpin
                .as_ref()
                .map(|axis| axis.each_ref().map(point)),
        }
    }
}

pub(super) fn drives(system: &System) -> Vec<Drive> {
    let drive = |drive: &system::Drive| Drive {
        quantity: Measure::new(system, &drive.quantity),
        angle_of: drive.angle_of.as_ref().map(|name| distance(system, name)),
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
