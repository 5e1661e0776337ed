//! The saloon for an engine: both sides, from the listings.

use std::error::Error;

use nalgebra::Vector3;
use suspension_car::car::Car;
use suspension_car::drive::DRIVER;
use suspension_car::linkages::{front, rear};
use suspension_car::saloon::{GRAVITY, SALOON};

use crate::interface::{Corner, Design, POINTS};

impl Design {
    /// Describes the car at the start of the drive, for steps of `dt`.
    pub fn of(car: &Car, dt: f64, across: f64) -> Result<Self, Box<dyn Error>> {
        let [front, rear] = [front_points()?, rear_points()?];
        let corner = |place: usize| {
            let (left, axle) = ([&front, &rear][place / 2], &SALOON.axles[place / 2]);
            let origin = car.corners[place & 2].hub.centre.value - left[0];
            let mut points = left.map(|point| point + origin);
            if place % 2 == 1 {
                points.iter_mut().for_each(|point| point.y = -point.y);
            }
            Corner {
                points: points.map(Into::into),
                mass: axle.unsprung_mass,
                spin_inertia: axle.spin_inertia,
                spin: car.corners[place].spin,
            }
        };
        Ok(Self {
            mass: SALOON.sprung_mass,
            inertia: SALOON.inertia,
            height: SALOON.height,
            speed: DRIVER.speed,
            gravity: GRAVITY,
            dt,
            across,
            corners: std::array::from_fn(corner),
        })
    }
}

fn front_points() -> Result<[Vector3<f64>; POINTS], Box<dyn Error>> {
    let at = front::Corner::<f64>::design()?.points().value;
    let mut points = [Vector3::zeros(); POINTS];
    points[..12].copy_from_slice(&[
        at.wheel_centre,
        at.axle,
        at.strut_upper,
        at.strut_lower,
        at.lower_front,
        at.lower_rear,
        at.upper_front,
        at.upper_rear,
        at.rack,
        at.lower_ball,
        at.upper_ball,
        at.tie_ball,
    ]);
    Ok(points)
}

fn rear_points() -> Result<[Vector3<f64>; POINTS], Box<dyn Error>> {
    let at = rear::Corner::<f64>::design()?.points().value;
    Ok([
        at.wheel_centre,
        at.axle,
        at.strut_upper,
        at.lateral_ball,
        at.lateral_inner,
        at.diagonal_inner,
        at.upper_front_inner,
        at.upper_rear_inner,
        at.toe_inner,
        at.lateral_ball,
        at.diagonal_ball,
        at.upper_front_ball,
        at.upper_rear_ball,
        at.toe_ball,
    ])
}
