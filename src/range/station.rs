//! A place on the curve of a freed drive as a row of numbers, and the names of its columns.

use suspension_core::path::{Curve, Place};
use suspension_core::wheel::{Kingpin, Wheel};
use suspension_core::{DriveKind, HasKingpin, HasWheel, LocalOrigin, Named, Parts, Signal, Values};

use crate::input::drives::unit_of;
use crate::input::file::Unit;
use crate::study::Suspension;
use crate::study::columns::PointNames;

/// A place on the curve of a freed drive.
#[derive(Clone, Debug, PartialEq)]
pub struct Station {
    /// The drive's value, in rad or the unit.
    pub value: f64,
    /// The height of the wheel centre, in the unit.
    pub height: f64,
    /// How far the free points move, the root of the sum of their squares, for a unit of the
    /// drive: in the unit for a radian, or for one of its own. Infinite where the drive turns.
    pub speed: f64,
    /// Its row.
    pub row: Vec<f64>,
}

/// The columns' names, in the order of the numbers of a [`Station`]'s row.
pub fn names<L: Suspension<N>, const N: usize>(unit: Unit) -> Vec<String> {
    let points = PointNames::of::<L, N>();
    let drives = <L::Drives as Named<f64>>::NAMES.iter().enumerate();
    let mut columns = vec!["freed".to_owned(), "turns".to_owned()];
    columns.extend(drives.map(|(drive, name)| {
        let kind = L::Listing::default().drive_kind(drive);
        format!("{name}_{}", unit_of(kind, unit))
    }));
    columns.push(format!("speed_{}", unit_of(DriveKind::Coordinate, unit)));
    for name in points.free.iter().chain(&points.markers) {
        columns.extend(["x", "y", "z"].map(|axis| format!("{name}_{axis}")));
    }
    let scalars = ["kingpin_rad", "caster_rad", "camber_rad", "toe_rad"];
    columns.extend(scalars.map(String::from));
    columns.push(format!("residual_{}", unit.symbol()));
    columns
}

/// The station at a place, its points in the coordinates in which `origin` is stated. `drives` are
/// the drives' values, `freed` is the number of the free one.
pub fn station<L: Suspension<N>, const N: usize>(
    curve: &Curve<'_, L, N>,
    place: &Place<f64, N>,
    origin: &LocalOrigin<f64>,
    turns: bool,
    [freed, drives]: [&[f64]; 2],
) -> Station {
    let (tangent, at) = (&place.tangent, &place.configuration);
    let rate = curve.value(&Signal {
        value: at.drive,
        rate: tangent.drive,
        second_rate: 0.0,
    });
    let speed = if turns {
        f64::INFINITY
    } else {
        tangent.unknowns.norm() / rate.rate.abs()
    };
    let points = curve.points(at);
    let chassis = <L::Fixed as Named<nalgebra::Vector3<f64>>>::NAMES.len();
    let placed = origin.from_local(&points);
    let [_, centre] = placed.wheel();
    let mut row = freed.to_vec();
    row.push(f64::from(u8::from(turns)));
    row.extend(drives);
    row.push(speed);
    row.extend(
        placed
            .values()
            .skip(chassis)
            .flat_map(|point| [point.x, point.y, point.z]),
    );
    let kingpin = Kingpin::of(points.kingpin(), points.wheel());
    let wheel = Wheel::of(points.wheel());
    let [camber, toe] = wheel.map_or([f64::NAN; 2], |wheel| [wheel.camber, wheel.toe]);
    row.extend([kingpin.angle, kingpin.caster, camber, toe, place.residual]);
    Station {
        value: place.value,
        height: centre.z,
        speed,
        row,
    }
}
