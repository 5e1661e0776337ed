//! Readings of the support of brake and drive forces by the suspension.

use crate::file::Dimension;
use crate::mechanism::{Axle, Names, Torque, Vehicle, Wheel};
use crate::quantities::formulas::Reading;
use crate::quantities::number::Number;
use crate::quantities::reader::wheel::{CarrierMotion, MovingWheel};
use crate::quantities::readings::ground::{moving, of_moving};
use crate::quantities::readings::of_each_wheel;

/// How far the point at which the force of a torque acts moves forward and upwards in bump, in whichever direction
/// the drives move the wheel. The point is the contact point, taken as a point of the carrier that bears the torque,
/// or the wheel centre.
fn forward_and_upward<N: Number>(moving: &MovingWheel<N>, torque: Torque) -> [N; 2] {
    let velocity = match torque {
        Torque::Carrier => moving.carrier.velocity_of(&moving.contact),
        Torque::Chassis => moving.carrier.velocity,
    };
    if velocity.z.is_below_zero() {
        [-velocity.x, -velocity.z]
    } else {
        [velocity.x, velocity.z]
    }
}

/// The angle from the vertical of this point's path in bump, in the side view.
pub(crate) fn of_support_angle<N: Number>(names: &Names, torque: Torque) -> Vec<Reading<N>> {
    let on_ground = torque == Torque::Carrier;
    of_moving(
        names,
        CarrierMotion::SideView,
        Dimension::Angle,
        on_ground,
        move |moving: &MovingWheel<N>| {
            let [forward, upward] = forward_and_upward(moving, torque);
            N::arc_tangent(forward, upward)
        },
    )
}

/// The forces of a car that its axles share.
#[derive(Clone, Copy)]
pub(crate) enum Force {
    Brakes,
    Drive,
}

impl Force {
    /// The axle's share of it, and the part that bears its torque.
    fn share_and_torque(self, wheel: &Wheel) -> (Option<f64>, Torque) {
        match self {
            Self::Brakes => (wheel.brake_share, wheel.brake_torque),
            Self::Drive => (wheel.drive_share, wheel.drive_torque),
        }
    }
}

/// The fraction of the car's load transfer that links bear instead of springs; `towards` is 1 if a path forward in
/// bump bears it, -1 if a path rearward does.
pub(crate) fn of_support<N: Number>(
    names: &Names,
    axle: Axle,
    force: Force,
    towards: f64,
) -> Vec<Reading<N>> {
    let Vehicle {
        wheelbase,
        cg_height,
        ..
    } = &names.vehicle;
    let Some((wheelbase, cg_height)) = wheelbase.zip(*cg_height) else {
        return Vec::new();
    };
    of_each_wheel(names, &|rolling| {
        let wheel = &names.wheels[rolling.number];
        let (share, torque) = force.share_and_torque(wheel);
        let share = share.filter(|_| wheel.axle == Some(axle))?;
        let factor = N::still(100.0 * towards * share * wheelbase / cg_height);
        let on_ground = torque == Torque::Carrier;
        moving(
            rolling,
            CarrierMotion::SideView,
            Dimension::Percent,
            on_ground,
            move |moving: &MovingWheel<N>| {
                let [forward, upward] = forward_and_upward(moving, torque);
                forward / upward * factor
            },
        )
    })
}
