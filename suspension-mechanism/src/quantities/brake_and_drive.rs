//! Readings of how a suspension bears the forces of brakes and drive.

use crate::mechanism::{Axle, Names, Vehicle};
use crate::quantities::formulas::Reading;
use crate::quantities::kind::Kind;
use crate::quantities::number::Number;
use crate::quantities::on_ground::{moving, of_moving};
use crate::quantities::readings::of_each_wheel;
use crate::quantities::wheel::{Along, Moving};

/// What the wheel's torque is borne by, which decides where the force acts.
#[derive(Clone, Copy)]
pub(super) enum Torque {
    /// Brakes on the carrier: the force acts at the contact point, as if that were of the carrier.
    OfBrakes,
    /// Shafts from the chassis: the force acts at the wheel centre.
    OfShafts,
}

impl Torque {
    fn is_on_ground(self) -> bool {
        matches!(self, Self::OfBrakes)
    }

    /// How far the point where the force acts goes forward and upwards in bump, whichever way the drive moves the wheel.
    fn forward_and_upward<N: Number>(self, moving: &Moving<N>) -> [N; 2] {
        let velocity = match self {
            Self::OfBrakes => moving.carrier.velocity_of(&moving.contact),
            Self::OfShafts => moving.carrier.velocity,
        };
        if velocity.z.is_below_zero() {
            [-velocity.x, -velocity.z]
        } else {
            [velocity.x, velocity.z]
        }
    }
}

/// The angle of the path in bump from the vertical in the side view.
pub(super) fn of_support_angle<N: Number>(names: &Names, torque: Torque) -> Vec<Reading<N>> {
    of_moving(
        names,
        Along::Travel,
        Kind::Angle,
        torque.is_on_ground(),
        move |moving: &Moving<N>| {
            let [forward, upward] = torque.forward_and_upward(moving);
            N::arc_tangent(forward, upward)
        },
    )
}

/// The part of the car's load transfer that links bear in place of springs; `towards` is 1 where a path forward
/// in bump bears it, -1 where one rearward does.
pub(super) fn of_support<N: Number>(
    names: &Names,
    axle: Axle,
    torque: Torque,
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
        let share = match torque {
            Torque::OfBrakes => wheel.brake_share,
            Torque::OfShafts => wheel.drive_share,
        };
        let Some(share) = share.filter(|_| wheel.axle == Some(axle)) else {
            return Vec::new();
        };
        let factor = N::still(100.0 * towards * share * wheelbase / cg_height);
        let on_ground = torque.is_on_ground();
        moving(
            rolling,
            Along::Travel,
            Kind::Percent,
            on_ground,
            move |moving: &Moving<N>| {
                let [forward, upward] = torque.forward_and_upward(moving);
                forward / upward * factor
            },
        )
    })
}
