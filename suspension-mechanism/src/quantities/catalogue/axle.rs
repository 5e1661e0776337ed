//! Both wheels of an axle: toe and track, steering, and roll.

use suspension_core::wheel::{steer_angle, toe};

use crate::file::Dimension;
use crate::quantities::number::Number;
use crate::quantities::quantity::{Quantity, Shown};
use crate::quantities::readings::axle::{
    of_both, of_both_from_design, of_roll, of_roll_centre, of_steered_wheels, of_turn, track,
};
use crate::quantities::readings::springs;

catalogue! {
    TOTAL_TOE: "total toe" {
        name: "total_toe",
        sign: "positive where the fronts of the wheels are closer together than their rears",
        definition: "the sum of both toe angles of an axle",
        source: "as toe",
        shown: Shown::InTables,
        read: |names| of_both(names, Dimension::Angle, false, |wheels| {
            let [left, right] = wheels.map(|wheel| toe(&wheel.axis));
            left + right
        }),
    }
    TRACK: "track" {
        name: "track",
        sign: "",
        definition: "the distance from the right contact point to the left one, along y; its derivatives are the \
                     change of track",
        source: "ISO 8855",
        shown: Shown::InTables,
        read: |names| of_both(names, Dimension::Length, true, track),
    }
    TRACK_CHANGE: "change of track" {
        name: "track_change",
        sign: "positive where the track is wider",
        definition: "the track less its value at the design position",
        source: "as track",
        zero_at_design: (&TRACK, None),
        shown: Shown::InTables,
        read: |names| of_both_from_design(names, Dimension::Length, |now, design| track(now) - track(design)),
    }
    STEER_ANGLE: "steer angle" {
        name: "steer_angle",
        sign: "positive where the wheel points to the left",
        definition: "the angle of the plane of the wheel from the x axis in the x-y plane, toe included",
        source: "ISO 8855",
        shown: Shown::InTables,
        read: |names| of_steered_wheels(names, steer_angle),
    }
    ACKERMANN: "Ackermann percentage" {
        name: "ackermann",
        sign: "100 where the normals of both wheels meet on the line of the rear axle, 0 where they are parallel",
        definition: "100 (inner - outer) / (ideal - outer) of the steer angles, with cot(ideal) = cot(outer) - track \
                     / wheelbase; none where a wheel is steered by less than a degree into the turn, as toe determines \
                     it there. A rear axle has none, and no axle has one where drives steer rear wheels",
        source: "given the outer wheel, as in the reports of Simscape Multibody",
        vehicle: "wheelbase",
        shown: Shown::InTables,
        read: |names| of_turn(names, Dimension::Percent, |turn, wheelbase, track| {
            turn.ackermann(wheelbase, track) * Number::still(100.0)
        }),
    }
    ACKERMANN_ERROR: "Ackermann error" {
        name: "ackermann_error",
        sign: "positive where the inner wheel is steered further than ideally",
        definition: "inner - ideal of the steer angles, with cot(ideal) = cot(outer) - track / wheelbase; none where \
                     a wheel is steered by less than a degree into the turn. A rear axle has none, and no axle has \
                     one where drives steer rear wheels",
        source: "as ackermann",
        vehicle: "wheelbase",
        shown: Shown::InTables,
        read: |names| of_turn(names, Dimension::Angle, |turn, wheelbase, track| {
            turn.inner - turn.ideal_inner(wheelbase, track)
        }),
    }
    TURNING_RADIUS: "radius of the turning circle" {
        name: "turning_radius",
        sign: "",
        definition: "kerb to kerb: the radius of the path of the outer contact point about a centre on the line of \
                     the rear axle, wheelbase / sin(outer), whose wheels point straight ahead; none where a wheel is \
                     steered by less than a degree into the turn. A rear axle has none, and no axle has one where \
                     drives steer rear wheels",
        source: "half the turning circle",
        vehicle: "wheelbase",
        shown: Shown::InTables,
        read: |names| of_turn(names, Dimension::Length, |turn, wheelbase, _| turn.radius(wheelbase)),
    }
    AXLE_ROLL_CENTRE: "roll centre of the axle" {
        name: "axle_roll_centre",
        sign: "in the axes and from the origin of the file",
        definition: "the point where, seen from the front, the normals to the velocities of both contact points meet \
                     in roll. In roll the left contact point rises as fast as the right one falls, each as a point of \
                     its carrier. The axle may be asymmetric; each wheel needs a drive of travel. Where both normals \
                     are level, as of trailing arms, the roll centre is on the ground in the middle, without \
                     derivatives",
        source: "kinematic roll centre; SAE J670",
        shown: Shown::InTables,
        read: of_roll_centre,
    }
    ROLL_CAMBER: "roll camber" {
        name: "roll_camber",
        sign: "positive where the top of the wheel leans further outboard as the left wheel rises",
        definition: "the derivative of the camber angle, relative to the chassis, with respect to the roll angle of \
                     the axle, in the roll of axle_roll_centre. The roll angle is that of the line through both \
                     contact points from the y axis, seen from the front; there they count as the lowest points of \
                     the wheels, not as points of the carriers",
        source: "roll camber coefficient, relative to the chassis",
        shown: Shown::InTables,
        read: |names| of_roll(names, |per_roll| per_roll.camber),
    }
    ROLL_STEER: "roll steer" {
        name: "roll_steer",
        sign: "positive where the wheel turns to the left as the left wheel rises",
        definition: "the derivative of the steer angle with respect to the roll angle of the axle, as defined for roll_camber",
        source: "roll steer coefficient",
        shown: Shown::InTables,
        read: |names| of_roll(names, |per_roll| per_roll.steer),
    }
    HEAVE_RATE: "wheel rate in heave" {
        name: "heave_rate",
        sign: "positive where the springs push back",
        definition: "the wheel rate of each wheel where both wheel centres rise alike, from which ride frequencies \
                     follow. It is half the rate of the axle, whose wheels have drives of their own. Where both sides \
                     stand alike, an anti-roll bar adds nothing to it",
        source: "virtual work",
        shown: Shown::InTables,
        read: springs::of_heave,
    }
    ROLL_RATE: "roll rate of the axle" {
        name: "roll_rate",
        sign: "positive where the springs push back",
        definition: "the rate of springs and bars together while the left wheel centre rises as fast as the right one \
                     falls: sum rate (ds/dp)^2 - F d2s/dp2, with p the angle of the line through the wheel centres in \
                     the front view",
        source: "virtual work; without the tyres",
        shown: Shown::InTables,
        read: springs::of_roll,
    }
}
