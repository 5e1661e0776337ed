//! The parts of a mechanism with the loads that a load case gives them, in the order of tables and reports.

use nalgebra::Vector3;

use crate::file::Dimension;
use crate::loads::{By, Outcome};
use crate::mechanism::Names;

/// A part, by its number; for joints and moments what exerts them.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Part {
    Drive(usize),
    Measure(usize),
    Link(usize),
    /// At a point.
    Joint(By, usize),
    /// On a part.
    Moment(By, usize),
    ChassisPoint(usize),
}

/// A load: along a drive, a measure or a link, or in space.
#[derive(Clone, Copy)]
pub(super) enum Load<'a> {
    Along(f64),
    Vector(&'a Vector3<f64>),
}

/// Returns the parts of an outcome with their loads.
pub(super) fn parts(outcome: &Outcome) -> impl Iterator<Item = (Part, Load<'_>)> {
    let drives = outcome.on_drives.iter().enumerate();
    let drives = drives.map(|(drive, load)| (Part::Drive(drive), Load::Along(*load)));
    let measures = outcome.in_measures.iter();
    let measures = measures.map(|(measure, load)| (Part::Measure(*measure), Load::Along(*load)));
    let links = outcome.links.iter();
    let links = links.map(|(link, tension)| (Part::Link(*link), Load::Along(*tension)));
    let joints = outcome.joints.iter();
    let joints = joints.map(|(by, at, force)| (Part::Joint(*by, *at), Load::Vector(force)));
    let moments = outcome.moments.iter();
    let moments = moments.map(|(by, on, moment)| (Part::Moment(*by, *on), Load::Vector(moment)));
    let chassis = outcome.on_chassis.iter();
    let chassis = chassis.map(|(point, force)| (Part::ChassisPoint(*point), Load::Vector(force)));
    let along = drives.chain(measures).chain(links);
    along.chain(joints).chain(moments).chain(chassis)
}

impl Part {
    /// Returns the unit of its load.
    pub(super) fn unit(self, names: &Names) -> &'static str {
        match self {
            Self::Drive(drive) => unit_of(names.drives[drive].kind),
            Self::Measure(measure) => unit_of(names.measures[measure].kind),
            Self::Moment(..) => unit_of(Dimension::Angle),
            Self::Link(_) | Self::Joint(..) | Self::ChassisPoint(_) => unit_of(Dimension::Length),
        }
    }
}

impl Load<'_> {
    /// Returns the load along a line, or the magnitude of one in space.
    pub(super) fn size(self) -> f64 {
        match self {
            Self::Along(load) => load,
            Self::Vector(load) => load.norm(),
        }
    }

    /// Returns its numbers, each with the axis in names of columns.
    pub(super) fn numbers(self) -> Vec<(&'static str, f64)> {
        match self {
            Self::Along(load) => vec![("", load)],
            Self::Vector(load) => vec![("_x", load.x), ("_y", load.y), ("_z", load.z)],
        }
    }
}

/// Returns the unit of a load along a coordinate.
fn unit_of(kind: impl Into<Dimension>) -> &'static str {
    match kind.into() {
        Dimension::Angle => "N m",
        _ => "N",
    }
}
