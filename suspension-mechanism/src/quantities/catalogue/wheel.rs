//! The wheel and the kingpin through its ball joints.

use suspension_core::wheel::{SteeringAxis, camber, camber_to_ground, caster, kingpin_angle, toe};

use crate::quantities::quantity::{Quantity, Shown};
use crate::quantities::readings::ground::{of_contact, of_kingpin_at_centre, of_kingpin_at_ground};
use crate::quantities::readings::{
    of_each_wheel, of_kingpin, of_kingpin_and_spin_axis, of_spin_axis, place,
};

catalogue! {
    CENTRE: "wheel centre" {
        name: "centre",
        sign: "in the axes of the file",
        definition: "the last point of the spin axis",
        source: "`wheel` of the listing",
        shown: Shown::InSummaries,
        read: |names| of_each_wheel(names, &|rolling| {
            let [_, centre] = rolling.points.axis;
            place(move |reader| reader.positions.at(centre))
        }),
    }
    CONTACT: "contact point" {
        name: "contact",
        sign: "in the axes of the file",
        definition: "the lowest point of the circle of wheel_radius about the wheel centre, normal to the spin axis",
        source: "flat, level ground; `wheel_radius` of the motion file",
        shown: Shown::InTables,
        read: of_contact,
    }
    KINGPIN: "kingpin angle" {
        name: "kingpin",
        sign: "positive where the top of the kingpin leans inboard",
        definition: "the kingpin inclination: the angle of the kingpin from the vertical in the y-z plane, atan2(-k_y, k_z) \
                     on the left",
        source: "ISO 8855",
        shown: Shown::InBoth,
        read: |names| of_kingpin_and_spin_axis(names, kingpin_angle),
    }
    CASTER: "caster angle" {
        name: "caster",
        sign: "positive where the top of the kingpin leans rearwards",
        definition: "the angle of the kingpin from the vertical in the x-z plane, atan2(-k_x, k_z)",
        source: "ISO 8855",
        shown: Shown::InBoth,
        read: |names| of_kingpin(names, caster),
    }
    CAMBER: "camber angle" {
        name: "camber",
        sign: "positive where the top of the wheel leans outboard",
        definition: "the angle of the spin axis from the y axis in the y-z plane, atan2(-s_z, |s_y|). Its derivative with \
                     respect to wheel travel is bump camber, or camber gain",
        source: "projection as in Suspension Explorer, sign of ISO 8855",
        shown: Shown::InBoth,
        read: |names| of_spin_axis(names, camber),
    }
    CAMBER_TO_GROUND: "camber angle to the ground" {
        name: "camber_to_ground",
        sign: "positive where the top of the wheel leans outboard",
        definition: "the angle of the spin axis from the ground, asin(-s_z / |s|); it differs from camber where the \
                     wheel is steered",
        source: "Adams/Car",
        shown: Shown::InTables,
        read: |names| of_spin_axis(names, camber_to_ground),
    }
    TOE: "toe angle" {
        name: "toe",
        sign: "positive where the front of the wheel points inboard",
        definition: "the angle of the spin axis from the y axis in the x-y plane, atan2(s_x, |s_y|). Its derivative with \
                     respect to wheel travel is bump steer",
        source: "ISO 8855",
        shown: Shown::InBoth,
        read: |names| of_spin_axis(names, toe),
    }
    SCRUB_RADIUS: "scrub radius" {
        name: "scrub_radius",
        sign: "positive where the kingpin meets the ground inboard of the contact point",
        definition: "the distance from the point where the kingpin meets the ground to the contact point, along the \
                     horizontal part of the spin axis",
        source: "ISO 8855, steering-axis offset at ground",
        shown: Shown::InTables,
        read: |names| of_kingpin_at_ground(names, SteeringAxis::inboard_of),
    }
    MECHANICAL_TRAIL: "mechanical trail" {
        name: "mechanical_trail",
        sign: "positive where the kingpin meets the ground ahead of the contact point",
        definition: "the distance from the contact point to the point where the kingpin meets the ground, along the \
                     heading of the wheel",
        source: "ISO 8855, castor offset at ground",
        shown: Shown::InTables,
        read: |names| of_kingpin_at_ground(names, SteeringAxis::ahead_of),
    }
    KINGPIN_OFFSET: "kingpin offset at the wheel centre" {
        name: "kingpin_offset",
        sign: "positive where the kingpin passes inboard of the wheel centre",
        definition: "the distance from kingpin to wheel centre at the height of the wheel centre, along the \
                     horizontal part of the spin axis",
        source: "ISO 8855, steering-axis offset at wheel centre",
        shown: Shown::InTables,
        read: |names| of_kingpin_at_centre(names, SteeringAxis::inboard_of),
    }
    CASTER_OFFSET: "caster offset at the wheel centre" {
        name: "caster_offset",
        sign: "positive where the kingpin passes ahead of the wheel centre",
        definition: "the distance from kingpin to wheel centre at the height of the wheel centre, along the heading \
                     of the wheel",
        source: "ISO 8855, castor offset at wheel centre",
        shown: Shown::InTables,
        read: |names| of_kingpin_at_centre(names, SteeringAxis::ahead_of),
    }
}
