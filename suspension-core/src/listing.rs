//! The parts of a listing, their names and kinds, independent of its geometry.

use core::f64::consts::{PI, TAU};

use crate::arithmetic::scalar::Real;

/// The parts of a listing: a listing has them, and so has a model made from it. A type that holds them in a table
/// implements only [`table`](Self::table); any other type implements all other methods.
pub trait Parts {
    /// The parts of a listing that `linkage!` has written.
    fn table(&self) -> &Names {
        &Names::NONE
    }

    /// The name of a part; the name of an unknown consists of its point and axis, `ball.x`. `?` if there is no such
    /// part.
    fn name(&self, part: Part) -> &str {
        self.table().name(part)
    }

    /// The number of parts of a kind.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn count(&self, kind: Kind) -> usize {
        self.table().count(kind)
    }

    /// The kind of the drive with this index.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn drive_kind(&self, drive: usize) -> DriveKind {
        let kind = self.table().drive_kinds.get(drive).copied();
        kind.unwrap_or(DriveKind::Coordinate)
    }

    /// The kind of the measure with this index.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn measure_kind(&self, measure: usize) -> MeasureKind {
        let kind = self.table().measure_kinds.get(measure).copied();
        kind.unwrap_or(MeasureKind::Length)
    }

    /// The wheel with this index, in the order of the listing; `None` beyond the last.
    fn wheel(&self, wheel: usize) -> Option<WheelPlaces<'_>> {
        self.table().wheels.get(wheel).copied()
    }
}

impl<P: Parts + ?Sized> Parts for &P {
    fn name(&self, part: Part) -> &str {
        (**self).name(part)
    }

    fn count(&self, kind: Kind) -> usize {
        (**self).count(kind)
    }

    fn drive_kind(&self, drive: usize) -> DriveKind {
        (**self).drive_kind(drive)
    }

    fn measure_kind(&self, measure: usize) -> MeasureKind {
        (**self).measure_kind(measure)
    }

    fn wheel(&self, wheel: usize) -> Option<WheelPlaces<'_>> {
        (**self).wheel(wheel)
    }
}

/// A part of a linkage by its number, which [`Parts::name`] turns into the name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// A row of the residual and the Jacobian.
    Equation(usize),
    /// An entry of `q`, a column of the Jacobian.
    Unknown(usize),
    /// A point: chassis points come first, then free points, then markers.
    Point(usize),
    /// A drive.
    Drive(usize),
    /// A measure.
    Measure(usize),
    /// A length.
    Length(usize),
}

impl Part {
    /// The name of its kind.
    pub fn kind(self) -> &'static str {
        match self {
            Self::Equation(_) => "equation",
            Self::Unknown(_) => "unknown",
            Self::Point(_) => "point",
            Self::Drive(_) => "drive",
            Self::Measure(_) => "measure",
            Self::Length(_) => "length",
        }
    }

    /// Its number among the parts of its kind.
    pub fn index(self) -> usize {
        match self {
            Self::Equation(index)
            | Self::Unknown(index)
            | Self::Point(index)
            | Self::Drive(index)
            | Self::Measure(index)
            | Self::Length(index) => index,
        }
    }
}

/// A kind of part that is counted: see [`Parts::count`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// Unknowns, and as many equations: `N`, or fewer if a model has room for more.
    Unknown,
    /// Chassis points.
    ChassisPoint,
    /// Free points.
    FreePoint,
    /// Markers.
    Marker,
    /// Drives.
    Drive,
    /// Measures.
    Measure,
    /// Lengths.
    Length,
}

impl Kind {
    /// The kinds of points, in the order of all points.
    pub const POINTS: [Self; 3] = [Self::ChassisPoint, Self::FreePoint, Self::Marker];
}

/// The kind of a drive's value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DriveKind {
    /// A coordinate of a point, or a sum of coordinates, or a length, in the unit of the hardpoints. Only the square of a
    /// length enters the equations: a value below zero acts as the length without its sign.
    Coordinate,
    /// The angle in radians, from 0 to pi, between a link and the positive direction of an axis. Only its cosine
    /// enters the equations: an angle beyond that range acts as the angle within it that has the same cosine.
    Angle,
    /// The angle in radians between two lines about a third one, less than a whole turn in either direction.
    Turn,
}

impl DriveKind {
    /// Whether the value is in radians.
    pub fn is_angle(self) -> bool {
        self != Self::Coordinate
    }

    /// The end of an angle's range that `value`, in radians, is beyond.
    #[inline]
    pub fn end_exceeded<T: Real>(self, value: T) -> Option<T> {
        let [least, greatest] = match self {
            Self::Coordinate => return None,
            Self::Angle => [0.0, PI],
            Self::Turn => [-TAU, TAU],
        }
        .map(T::constant);
        let is_within = match self {
            Self::Turn => least < value && value < greatest,
            _ => least <= value && value <= greatest,
        };
        (!is_within).then_some(if value <= least { least } else { greatest })
    }
}

/// The kind of a measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasureKind {
    /// A length, a coordinate or a sum of coordinates, in the unit of the hardpoints.
    Length,
    /// An angle in radians, from 0 to pi, or from -pi to pi if it is about a line.
    Angle,
}

/// A wheel that a listing states: its name, and the indices of its points among all points ([`Part::Point`]).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WheelPlaces<'a> {
    /// Its name; empty for a single wheel that is stated without one.
    pub name: &'a str,
    /// Two points on its spin axis, the wheel centre last.
    pub axis: [usize; 2],
    /// Three points of the body that carries it.
    pub carrier: [usize; 3],
    /// The ends of its kingpin, the lower one first; `None` if the listing states none.
    pub kingpin: Option<[usize; 2]>,
}

/// The parts of a listing that `linkage!` has written: tables in the order of the parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Names {
    /// Rows of the residual and the Jacobian.
    pub equations: &'static [&'static str],
    /// Entries of `q`, columns of the Jacobian.
    pub unknowns: &'static [&'static str],
    /// Chassis points.
    pub chassis: &'static [&'static str],
    /// Chassis points, free points and markers.
    pub points: &'static [&'static str],
    /// The number of markers among the points.
    pub markers: usize,
    /// Drives.
    pub drives: &'static [&'static str],
    /// The kind of each drive.
    pub drive_kinds: &'static [DriveKind],
    /// Measures.
    pub measures: &'static [&'static str],
    /// The kind of each measure.
    pub measure_kinds: &'static [MeasureKind],
    /// Lengths.
    pub lengths: &'static [&'static str],
    /// Wheels.
    pub wheels: &'static [WheelPlaces<'static>],
}

impl Names {
    /// Empty tables.
    const NONE: Self = Self {
        equations: &[],
        unknowns: &[],
        chassis: &[],
        points: &[],
        markers: 0,
        drives: &[],
        drive_kinds: &[],
        measures: &[],
        measure_kinds: &[],
        lengths: &[],
        wheels: &[],
    };

    fn name(&self, part: Part) -> &str {
        let (table, index) = match part {
            Part::Equation(index) => (self.equations, index),
            Part::Unknown(index) => (self.unknowns, index),
            Part::Point(index) => (self.points, index),
            Part::Drive(index) => (self.drives, index),
            Part::Measure(index) => (self.measures, index),
            Part::Length(index) => (self.lengths, index),
        };
        table.get(index).copied().unwrap_or("?")
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn count(&self, kind: Kind) -> usize {
        match kind {
            Kind::Unknown => self.unknowns.len(),
            Kind::ChassisPoint => self.chassis.len(),
            Kind::FreePoint => self.points.len() - self.chassis.len() - self.markers,
            Kind::Marker => self.markers,
            Kind::Drive => self.drives.len(),
            Kind::Measure => self.measures.len(),
            Kind::Length => self.lengths.len(),
        }
    }
}
