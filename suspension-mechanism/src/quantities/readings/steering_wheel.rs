//! Readings of the steering wheel, and of the wheels that it turns.

use suspension_core::wheel::steer_rate;

use crate::file::Dimension;
use crate::mechanism::Names;
use crate::quantities::formulas::Reading;
use crate::quantities::number::Number;
use crate::quantities::reader::wheel::{CarrierMotion, MovingWheel};
use crate::quantities::readings::ground::moving;
use crate::quantities::readings::{of_each_wheel, without_derivatives};

/// The angle by which the steering wheel is turned from the design position.
pub(crate) fn of_angle<N: Number>(names: &Names) -> Vec<Reading<N>> {
    let wheel = names.vehicle.steering_wheel.iter();
    let readings = wheel.cloned().map(|wheel| {
        without_derivatives(Dimension::Angle, move |state| {
            Some(wheel.angle(&state.drives))
        })
    });
    readings.collect()
}

/// The steering wheel's angle per steer angle of each wheel that it steers.
pub(crate) fn of_ratio<N: Number>(names: &Names) -> Vec<Reading<N>> {
    of_each_wheel(names, &|rolling| {
        let wheel = names.vehicle.steering_wheel.as_ref();
        let wheel = wheel.filter(|wheel| wheel.turned.contains(&rolling.number))?;
        let per_drive = wheel.per_drive();
        let ratio = move |moving: &MovingWheel<N>| {
            let axis_rate = moving.carrier.omega.cross(&moving.axis);
            N::still(per_drive) / steer_rate(&moving.axis, &axis_rate)
        };
        moving(
            rolling,
            CarrierMotion::Steer,
            Dimension::AnglePerAngle,
            false,
            ratio,
        )
    })
}
