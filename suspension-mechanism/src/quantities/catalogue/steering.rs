//! The virtual steering axis, about which the carrier turns in steering, and the steering wheel.

use suspension_core::wheel::{caster, kingpin_angle};

use crate::file::Dimension;
use crate::quantities::quantity::{Quantity, Shown};
use crate::quantities::reader::wheel::{CarrierMotion, MovingWheel};
use crate::quantities::readings::ground::of_moving;
use crate::quantities::readings::steering_wheel;

catalogue! {
    VIRTUAL_KINGPIN: "kingpin angle of the virtual steering axis" {
        name: "virtual_kingpin",
        sign: "positive where the top of the axis leans inboard",
        definition: "the angle of the screw axis about which the wheel's carrier turns in steering, the other drives \
                     held. If travel is driven by the wheel's height, the carrier turns at constant height. If it is \
                     driven by a damper's length, the carrier turns with the spring locked, as in Adams/Car, and the \
                     axis of a carrier on two ball joints is its kingpin",
        source: "as kingpin",
        shown: Shown::InTables,
        read: |names| of_moving(names, CarrierMotion::Steer, Dimension::Angle, false, |moving| {
            kingpin_angle(&moving.screw().direction, &moving.axis)
        }),
    }
    VIRTUAL_CASTER: "caster angle of the virtual steering axis" {
        name: "virtual_caster",
        sign: "positive where the top of the axis leans rearwards",
        definition: "the angle of the screw axis of the wheel's carrier in steering, the other drives held",
        source: "as caster",
        shown: Shown::InTables,
        read: |names| of_moving(names, CarrierMotion::Steer, Dimension::Angle, false, |moving| {
            caster(&moving.screw().direction)
        }),
    }
    VIRTUAL_SCRUB_RADIUS: "scrub radius of the virtual steering axis" {
        name: "virtual_scrub_radius",
        sign: "positive where the axis meets the ground inboard of the contact point",
        definition: "for the screw axis of the wheel's carrier in steering, the other drives held",
        source: "as scrub_radius",
        shown: Shown::InTables,
        read: |names| of_moving(names, CarrierMotion::Steer, Dimension::Length, true, |moving| {
            moving.screw().inboard_of(&moving.contact, &moving.heading)
        }),
    }
    VIRTUAL_TRAIL: "mechanical trail of the virtual steering axis" {
        name: "virtual_trail",
        sign: "positive where the axis meets the ground ahead of the contact point",
        definition: "for the screw axis of the wheel's carrier in steering, the other drives held",
        source: "as mechanical_trail",
        shown: Shown::InTables,
        read: |names| of_moving(names, CarrierMotion::Steer, Dimension::Length, true, |moving| {
            moving.screw().ahead_of(&moving.contact, &moving.heading)
        }),
    }
    VIRTUAL_PITCH: "pitch of the virtual steering axis" {
        name: "virtual_pitch",
        sign: "positive where the carrier moves up the axis as it turns left",
        definition: "how far the carrier moves along the screw axis per unit of angle about it; zero where steering \
                     moves no ball joint of the kingpin",
        source: "omega . v / |omega|^2",
        shown: Shown::InTables,
        read: |names| of_moving(names, CarrierMotion::Steer, Dimension::LengthPerAngle, false, MovingWheel::pitch),
    }
    STEERING_WHEEL_ANGLE: "angle of the steering wheel" {
        name: "steering_wheel_angle",
        sign: "positive where the steering wheel is turned to the left: the way that turns the road wheels to the left at the \
               design position, whichever way the rack is counted",
        definition: "the angle from the design position: one turn for each rack_per_turn by which the drive of \
                     steering moves, or steering_box_ratio times the angle by which it turns. Its derivative with \
                     respect to that drive is constant, one turn / rack_per_turn or steering_box_ratio with its sign, \
                     and has no column",
        source: "ISO 8855",
        vehicle: "rack_per_turn or steering_box_ratio",
        zero_at_design: (&STEERING_RATIO, None),
        shown: Shown::InTables,
        read: steering_wheel::of_angle,
    }
    STEERING_RATIO: "overall steering ratio" {
        name: "steering_ratio",
        sign: "positive where the wheel turns the way of the steering wheel",
        definition: "the derivative of steering_wheel_angle with respect to the steer angle of the wheel, the other drives held",
        source: "Milliken 1995, chapter 19",
        vehicle: "rack_per_turn or steering_box_ratio",
        shown: Shown::InTables,
        read: steering_wheel::of_ratio,
    }
}
