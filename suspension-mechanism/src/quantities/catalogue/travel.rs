//! The motion of the carrier in travel: roll centre, instant centres, support of brakes and drive.

use nalgebra::Vector3;
use suspension_core::wheel::InstantCentre;

use crate::file::Dimension;
use crate::mechanism::{Axle, Torque};
use crate::quantities::axis::Axis;
use crate::quantities::number::Number;
use crate::quantities::quantity::{Quantity, Shown};
use crate::quantities::reader::wheel::CarrierMotion;
use crate::quantities::readings::brake_and_drive::{Force, of_support, of_support_angle};
use crate::quantities::readings::ground::{of_independent, of_moving, of_moving_place};

catalogue! {
    ROLL_CENTRE: "height of the roll centre above the ground" {
        name: "roll_centre",
        sign: "positive above the contact point",
        definition: "the height at which, seen from the front, the normal to the velocity of the contact point meets \
                     the middle of the vehicle, y = 0; the contact point moves with the carrier, in travel. It is the \
                     roll centre of the axle if the axle is symmetric and its wheels are independent. A wheel that \
                     another wheel moves, on one body or a twist beam, has none; its axle has axle_roll_centre. A \
                     wheel in the middle of the vehicle, as of a motorcycle, has none either",
        source: "kinematic roll centre; SAE J670",
        shown: Shown::InTables,
        read: |names| of_independent(names, |rolling| !rolling.is_in_middle(names), Dimension::Length, |moving| {
            moving.carrier.roll_centre(&moving.contact) - moving.contact.z
        }),
    }
    JACKING: "jacking by lateral force" {
        name: "jacking",
        sign: "positive where a force on the contact point towards the middle of the vehicle lifts the body",
        definition: "the part of a lateral force that lifts the body, for an axle of independent wheels: 100 v_y / \
                     v_z, with v the velocity in travel of the contact point as a point of the carrier, v_y outboard. \
                     It is the slope of the line from the contact point to the roll centre",
        source: "virtual work; Milliken 1995, chapter 17",
        shown: Shown::InTables,
        read: |names| of_independent(names, |_| true, Dimension::Percent, |moving| {
            moving.carrier.outboard_slope(&moving.contact, &moving.axis) * Number::still(100.0)
        }),
    }
    FRONT_CENTRE: "instant centre in the front view" {
        name: "front_centre",
        sign: "in the axes of the file",
        definition: "the instant centre of the wheel's carrier in travel, in the plane x = constant through the wheel \
                     centre; the other wheel of the axle is held at its height. There is none where the carrier does \
                     not turn in that view",
        source: "v + omega x r has no part in the plane",
        shown: Shown::InTables,
        read: |names| of_moving_place(names, CarrierMotion::Travel, &[Axis::Y, Axis::Z], |moving| {
            let InstantCentre { across, z, .. } = moving.front_view();
            Vector3::new(Number::unknown(), across, z)
        }),
    }
    FRONT_ARM: "swing arm in the front view" {
        name: "front_arm",
        sign: "positive where the instant centre lies inboard",
        definition: "the distance from the instant centre in the front view to the wheel centre, along y",
        source: "front-view swing-arm length",
        shown: Shown::InTables,
        read: |names| of_moving(names, CarrierMotion::Travel, Dimension::Length, false, |moving| {
            moving.front_view().arm
        }),
    }
    SIDE_CENTRE: "instant centre in the side view" {
        name: "side_centre",
        sign: "in the axes of the file",
        definition: "the instant centre of the wheel's carrier in travel, in the plane y = constant through the wheel \
                     centre. There is none where the carrier does not turn in that view. Where one wheel moves the \
                     other, on one body or a twist beam, the motion is heave: both wheel centres rise alike",
        source: "v + omega x r has no part in the plane",
        shown: Shown::InTables,
        read: |names| of_moving_place(names, CarrierMotion::SideView, &[Axis::X, Axis::Z], |moving| {
            let InstantCentre { across, z, .. } = moving.side_view();
            Vector3::new(across, Number::unknown(), z)
        }),
    }
    SIDE_ARM: "swing arm in the side view" {
        name: "side_arm",
        sign: "positive where the instant centre lies behind",
        definition: "the distance from side_centre to the wheel centre, along x",
        source: "side-view swing-arm length",
        shown: Shown::InTables,
        read: |names| of_moving(names, CarrierMotion::SideView, Dimension::Length, false, |moving| {
            moving.side_view().arm
        }),
    }
    BRAKE_ANGLE: "support angle of outboard brakes" {
        name: "brake_angle",
        sign: "positive where the contact point moves forward in bump",
        definition: "the angle of the path in travel of the contact point, as a point of the carrier, from the \
                     vertical in the side view, atan2(v_x, |v_z|) with v_z upwards. Its tangent is anti-dive or \
                     anti-lift without the car's share. Where one wheel moves the other, on one body or a twist beam, \
                     the motion is heave: both wheel centres rise alike",
        source: "side-view support angle, brake torque borne by the carrier",
        shown: Shown::InTables,
        read: |names| of_support_angle(names, Torque::Carrier),
    }
    DRIVE_ANGLE: "support angle of inboard drive" {
        name: "drive_angle",
        sign: "positive where the wheel centre moves forward in bump",
        definition: "the angle of the path in travel of the wheel centre from the vertical in the side view, \
                     atan2(v_x, |v_z|) with v_z upwards. Its tangent is anti-squat without the car's share. Where one \
                     wheel moves the other, the motion is heave, as for brake_angle",
        source: "side-view support angle, drive torque borne by the chassis",
        shown: Shown::InTables,
        read: |names| of_support_angle(names, Torque::Chassis),
    }
    ANTI_DIVE: "anti-dive" {
        name: "anti_dive",
        sign: "positive where braking pushes the front wheels down",
        definition: "for a front axle, 100 tan(angle) brake_share wheelbase / cg_height; angle is brake_angle, or \
                     drive_angle with brake_torque = 'chassis'",
        source: "Gillespie 1992, chapter 7",
        vehicle: "brake_share, wheelbase and cg_height",
        shown: Shown::InTables,
        read: |names| of_support(names, Axle::Front, Force::Brakes, 1.0),
    }
    ANTI_LIFT: "anti-lift" {
        name: "anti_lift",
        sign: "positive where braking pulls the rear wheels up",
        definition: "for a rear axle, -100 tan(angle) brake_share wheelbase / cg_height; angle is brake_angle, or \
                     drive_angle with brake_torque = 'chassis'",
        source: "Gillespie 1992, chapter 7",
        vehicle: "brake_share, wheelbase and cg_height",
        shown: Shown::InTables,
        read: |names| of_support(names, Axle::Rear, Force::Brakes, -1.0),
    }
    ANTI_SQUAT: "anti-squat" {
        name: "anti_squat",
        sign: "positive where driving pushes the rear wheels down",
        definition: "for a rear axle, -100 tan(angle) drive_share wheelbase / cg_height; angle is drive_angle if the \
                     chassis bears the drive_torque, brake_angle if the carrier does, such as an axle with the \
                     differential in it",
        source: "Gillespie 1992, chapter 7",
        vehicle: "drive_share, wheelbase and cg_height",
        shown: Shown::InTables,
        read: |names| of_support(names, Axle::Rear, Force::Drive, -1.0),
    }
    ANTI_LIFT_IN_DRIVE: "anti-lift in drive" {
        name: "anti_lift_in_drive",
        sign: "positive where driving pulls the front wheels up",
        definition: "for a front axle, 100 tan(angle) drive_share wheelbase / cg_height; angle as in anti_squat",
        source: "Gillespie 1992, chapter 7",
        vehicle: "drive_share, wheelbase and cg_height",
        shown: Shown::InTables,
        read: |names| of_support(names, Axle::Front, Force::Drive, 1.0),
    }
}
