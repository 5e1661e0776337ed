//! Kinematics from tables: piecewise polynomials of the drives in place of equations.

use nalgebra::Vector3;
use suspension_core::Signal;
use suspension_core::baked::{Curve, Outside, Surface};
use suspension_core::model::measure::length;

use super::{Drives, Hub, Kinematics, Refused, Why};

/// The number of points in a table: wheel centre, a point inboard of it on the spin axis, a point of the carrier off that
/// axis, and the lower end of the strut.
const POINTS: usize = 4;
/// The number of their coordinates.
pub const COORDINATES: usize = 3 * POINTS;
type Points = [Vector3<f64>; POINTS];

/// A baked motion over bump, or over bump and steer.
pub trait Table: Send {
    /// Returns coordinates with their rates and second rates for a motion of the drives, and their rates per bump.
    ///
    /// # Errors
    ///
    /// [`Outside`] beyond the table.
    fn motion(&self, drives: &Signal<[f64; 2]>) -> Result<[[f64; COORDINATES]; 4], Outside<f64>>;
}

impl<const TERMS: usize> Table for Surface<'static, f64, COORDINATES, TERMS> {
    fn motion(&self, drives: &Signal<[f64; 2]>) -> Result<[[f64; COORDINATES]; 4], Outside<f64>> {
        let place = self.at(drives.value)?;
        let [value, rate, second_rate] = place.acceleration(drives.rate, drives.second_rate);
        let [_, per_bump] = place.velocity([1.0, 0.0]);
        Ok([value, rate, second_rate, per_bump])
    }
}

impl<const TERMS: usize> Table for Curve<'static, f64, COORDINATES, TERMS> {
    fn motion(&self, drives: &Signal<[f64; 2]>) -> Result<[[f64; COORDINATES]; 4], Outside<f64>> {
        let [bump, rate, second_rate] =
            [drives.value, drives.rate, drives.second_rate].map(|[bump, _]| bump);
        let place = self.at(bump)?;
        let [value, rate, second_rate] = place.acceleration(rate, second_rate);
        let [_, per_bump] = place.velocity(1.0);
        Ok([value, rate, second_rate, per_bump])
    }
}

/// A corner that is looked up.
#[derive(Clone, Copy)]
pub struct Baked<T> {
    /// The motion of the points.
    pub table: T,
    /// Bump and steer in the design.
    pub design: [f64; 2],
    /// Chassis end of the strut.
    pub strut_upper: Vector3<f64>,
}

impl<T: Table> Kinematics for Baked<T> {
    fn step(&mut self, _dt: f64, drives: &Signal<Drives>) -> Result<Hub, Refused> {
        let mut moved = drives.map(|drives| [drives.travel, drives.rack]);
        for (value, design) in moved.value.iter_mut().zip(self.design) {
            *value += design;
        }
        let [value, rate, second_rate, per_travel] = self
            .table
            .motion(&moved)
            .map_err(|_| Refused {
                drives: drives.value,
                why: Why::OutsideTable,
            })?
            .map(points);
        let marks = |[centre, inner, beside, _]: Points| [centre, inner, beside];
        let motion = Signal {
            value: marks(value),
            rate: marks(rate),
            second_rate: marks(second_rate),
        };
        let strut = |rate: Points| {
            length(&Signal {
                value: self.strut_upper - value[3],
                rate: -rate[3],
                second_rate: Vector3::zeros(),
            })
        };
        let moving = strut(rate);
        Ok(Hub::new(
            &motion,
            [moving.value, moving.rate],
            &marks(per_travel),
            strut(per_travel).rate,
        ))
    }
}

fn points(coordinates: [f64; COORDINATES]) -> Points {
    std::array::from_fn(|point| Vector3::from_fn(|axis, _| coordinates[3 * point + axis]))
}
