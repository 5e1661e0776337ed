//! The catalogue: each quantity is one row. Signs and formulas are those of [`suspension_core::wheel`] and
//! [`suspension_core::body`].

use nalgebra::Vector3;
use suspension_core::body::{angular_acceleration, angular_velocity};
use suspension_core::wheel::{
    InstantCentre, SteeringAxis, camber, camber_to_ground, caster, kingpin_angle, toe,
};

use crate::mechanism::{Axle, Names, State, WheelPoints};
use crate::quantities::brake_and_drive::{Torque, of_support, of_support_angle};
use crate::quantities::kind::Kind;
use crate::quantities::on_ground::{
    of_contact, of_kingpin_at_centre, of_kingpin_at_ground, of_moving, of_moving_place,
};
use crate::quantities::quantity::{Axis, Quantity, Reading, Shown};
use crate::quantities::readings::{
    alone, each, number, of_kingpin, of_kingpin_and_spin_axis, of_spin_axis, place, point, vector,
};
use crate::quantities::wheel::{Along, Moving, at};

/// Makes a `static` of each row and the list of all.
macro_rules! catalogue {
    ($($row:ident: $title:literal { $($field:tt)* })+) => {
        $(
            #[doc = concat!("The row \"", $title, "\".")]
            pub static $row: Quantity = Quantity { title: $title, $($field)* };
        )+

        /// All rows, in the order in which tables have them.
        pub static CATALOGUE: &[&Quantity] = &[$(&$row),+];
    };
}

catalogue! {
    TIME: "time" {
        name: "t",
        sign: "",
        definition: "the instant",
        source: "the motion file",
        shown: Shown::InBoth,
        read: |_| number(Kind::Time, |state| state.t),
    }
    DRIVES: "drives" {
        name: "",
        sign: "",
        definition: "what each prescribes; one that a measure stands in for as the mechanism has it",
        source: "`drive` of the listing",
        shown: Shown::InBoth,
        read: |names| {
            let drives = names.drives.iter();
            let drives = drives.map(|drive| (drive.name.as_str(), drive.kind.into()));
            each(drives, false, |state, drive| alone(state.drives[drive]))
        },
    }
    POSITIONS: "free points" {
        name: "",
        sign: "x forward, y left, z up",
        definition: "the unknowns of the equations",
        source: "`free` of the listing",
        shown: Shown::InTables,
        read: |names| of_free_points(names, Kind::Length),
    }
    VELOCITIES: "velocities of free points" {
        name: "",
        sign: "",
        definition: "J qdot = -dF/du udot",
        source: "Attia 2003, eq. (3)",
        shown: Shown::InTables,
        read: |names| of_free_points(names, Kind::Velocity),
    }
    ACCELERATIONS: "accelerations of free points" {
        name: "",
        sign: "",
        definition: "J qddot = -C(qdot, qdot) - dF/du uddot",
        source: "Attia 2003, eq. (7) and (8)",
        shown: Shown::InTables,
        read: |names| of_free_points(names, Kind::Acceleration),
    }
    OMEGA: "angular velocity of the wheel's carrier" {
        name: "omega",
        sign: "right-handed",
        definition: "the least-squares fit of v = v0 + omega x r over three points",
        source: "Attia 2003, eq. (9), without its 0/0",
        shown: Shown::InTables,
        read: |names| of_carrier(names, Kind::AngularVelocity, |[omega, _]| omega),
    }
    ALPHA: "angular acceleration of the wheel's carrier" {
        name: "alpha",
        sign: "right-handed",
        definition: "the least-squares fit of a = a0 + alpha x r + omega x (omega x r) over three points",
        source: "Attia 2003, eq. (10), without its 0/0",
        shown: Shown::InTables,
        read: |names| of_carrier(names, Kind::AngularAcceleration, |[_, alpha]| alpha),
    }
    MARKERS: "markers, with velocities and accelerations" {
        name: "",
        sign: "x forward, y left, z up",
        definition: "points carried by bodies",
        source: "`point` of the listing",
        shown: Shown::InTables,
        read: |names| {
            let markers = names.chassis + names.free..names.points.len();
            let of_one = |marker| RATES.map(|kind| point(names, marker, kind)).into_iter();
            markers.flat_map(of_one).flatten().collect()
        },
    }
    CENTRE: "wheel centre" {
        name: "centre",
        sign: "x forward, y left, z up",
        definition: "the last point of the spin axis",
        source: "`wheel` of the listing",
        shown: Shown::InSummaries,
        read: |names| names.wheel.map_or_else(Vec::new, |WheelPoints { axis: [_, centre], .. }| {
            place(None, move |state| at(state, centre))
        }),
    }
    CONTACT: "contact point" {
        name: "contact",
        sign: "x forward, y left, z up",
        definition: "the lowest point of the circle of wheel_radius about the wheel centre, normal to the spin axis",
        source: "flat, level ground; `wheel_radius` of the motion file",
        shown: Shown::InTables,
        read: of_contact,
    }
    KINGPIN: "kingpin angle" {
        name: "kingpin",
        sign: "positive where the top of the kingpin leans inboard",
        definition: "from the vertical in the y-z plane, atan2(-k_y, k_z) on the left",
        source: "ISO 8855; Attia 2003, angle alpha, which has the opposite sign",
        shown: Shown::InBoth,
        read: |names| of_kingpin_and_spin_axis(names, kingpin_angle),
    }
    CASTER: "caster angle" {
        name: "caster",
        sign: "positive where the top of the kingpin leans rearwards",
        definition: "from the vertical in the x-z plane, atan2(-k_x, k_z)",
        source: "ISO 8855",
        shown: Shown::InBoth,
        read: |names| of_kingpin(names, caster),
    }
    CAMBER: "camber angle" {
        name: "camber",
        sign: "positive where the top of the wheel leans outboard",
        definition: "of the spin axis from the y axis in the y-z plane, atan2(-s_z, |s_y|)",
        source: "ISO 8855; Attia 2003, angle beta",
        shown: Shown::InBoth,
        read: |names| of_spin_axis(names, camber),
    }
    CAMBER_TO_GROUND: "camber angle to the ground" {
        name: "camber_to_ground",
        sign: "positive where the top of the wheel leans outboard",
        definition: "of the spin axis from the ground, asin(-s_z / |s|); differs where the wheel is steered",
        source: "Adams/Car",
        shown: Shown::InTables,
        read: |names| of_spin_axis(names, camber_to_ground),
    }
    SCRUB_RADIUS: "scrub radius" {
        name: "scrub_radius",
        sign: "positive where the kingpin meets the ground inboard of the contact point",
        definition: "from where the kingpin meets the ground to the contact point, along the horizontal part of the spin axis",
        source: "ISO 8855, steering-axis offset at ground",
        shown: Shown::InTables,
        read: |names| of_kingpin_at_ground(names, SteeringAxis::inboard_of),
    }
    MECHANICAL_TRAIL: "mechanical trail" {
        name: "mechanical_trail",
        sign: "positive where the kingpin meets the ground ahead of the contact point",
        definition: "from the contact point to where the kingpin meets the ground, along the heading of the wheel",
        source: "ISO 8855, castor offset at ground",
        shown: Shown::InTables,
        read: |names| of_kingpin_at_ground(names, SteeringAxis::ahead_of),
    }
    KINGPIN_OFFSET: "kingpin offset at the wheel centre" {
        name: "kingpin_offset",
        sign: "positive where the kingpin passes inboard of the wheel centre",
        definition: "at the height of the wheel centre, along the horizontal part of the spin axis",
        source: "ISO 8855, steering-axis offset at wheel centre",
        shown: Shown::InTables,
        read: |names| of_kingpin_at_centre(names, SteeringAxis::inboard_of),
    }
    CASTER_OFFSET: "caster offset at the wheel centre" {
        name: "caster_offset",
        sign: "positive where the kingpin passes ahead of the wheel centre",
        definition: "at the height of the wheel centre, along the heading of the wheel",
        source: "ISO 8855, castor offset at wheel centre",
        shown: Shown::InTables,
        read: |names| of_kingpin_at_centre(names, SteeringAxis::ahead_of),
    }
    VIRTUAL_KINGPIN: "kingpin angle of the virtual steering axis" {
        name: "virtual_kingpin",
        sign: "positive where the top of the axis leans inboard",
        definition: "of the screw axis of the wheel's carrier in steering, the other drives held",
        source: "as kingpin",
        shown: Shown::InTables,
        read: |names| of_moving(names, Along::Steer, Kind::Angle, false, |moving| {
            kingpin_angle(&moving.screw().direction, &moving.axis)
        }),
    }
    VIRTUAL_CASTER: "caster angle of the virtual steering axis" {
        name: "virtual_caster",
        sign: "positive where the top of the axis leans rearwards",
        definition: "of the screw axis of the wheel's carrier in steering, the other drives held",
        source: "as caster",
        shown: Shown::InTables,
        read: |names| of_moving(names, Along::Steer, Kind::Angle, false, |moving| {
            caster(&moving.screw().direction)
        }),
    }
    VIRTUAL_SCRUB_RADIUS: "scrub radius of the virtual steering axis" {
        name: "virtual_scrub_radius",
        sign: "positive where the axis meets the ground inboard of the contact point",
        definition: "of the screw axis of the wheel's carrier in steering, the other drives held",
        source: "as scrub_radius",
        shown: Shown::InTables,
        read: |names| of_moving(names, Along::Steer, Kind::Length, true, |moving| {
            moving.screw().inboard_of(&moving.contact, &moving.heading())
        }),
    }
    VIRTUAL_TRAIL: "mechanical trail of the virtual steering axis" {
        name: "virtual_trail",
        sign: "positive where the axis meets the ground ahead of the contact point",
        definition: "of the screw axis of the wheel's carrier in steering, the other drives held",
        source: "as mechanical_trail",
        shown: Shown::InTables,
        read: |names| of_moving(names, Along::Steer, Kind::Length, true, |moving| {
            moving.screw().ahead_of(&moving.contact, &moving.heading())
        }),
    }
    VIRTUAL_PITCH: "pitch of the virtual steering axis" {
        name: "virtual_pitch",
        sign: "positive where the carrier moves up the axis as it turns left",
        definition: "how far the carrier moves along the screw axis for a radian about it; zero where steering moves no \
                     ball joint of the kingpin",
        source: "omega . v / |omega|^2",
        shown: Shown::InTables,
        read: |names| of_moving(names, Along::Steer, Kind::LengthPerAngle, false, Moving::pitch),
    }
    ROLL_CENTRE: "height of the roll centre above the ground" {
        name: "roll_centre",
        sign: "positive above the contact point",
        definition: "of an axle that is symmetric about y = 0: where the normal to the velocity in travel of the \
                     contact point, as a point of the carrier, meets that plane in the front view",
        source: "kinematic roll centre; SAE J670",
        shown: Shown::InTables,
        read: |names| of_moving(names, Along::Travel, Kind::Length, true, |moving| {
            moving.carrier.roll_centre(&moving.contact) - moving.contact.z
        }),
    }
    FRONT_CENTRE: "instant centre in the front view" {
        name: "front_centre",
        sign: "y left, z up",
        definition: "of the wheel's carrier in travel, in the plane x = constant through the wheel centre",
        source: "v + omega x r has no part in the plane",
        shown: Shown::InTables,
        read: |names| of_moving_place(names, Along::Travel, &[Axis::Y, Axis::Z], |moving| {
            let InstantCentre { across, z, .. } = moving.carrier.front_view(&moving.axis);
            Vector3::new(alone(f64::NAN), across, z)
        }),
    }
    FRONT_ARM: "swing arm in the front view" {
        name: "front_arm",
        sign: "positive where the instant centre lies inboard",
        definition: "from the instant centre in the front view to the wheel centre, along y",
        source: "front-view swing-arm length",
        shown: Shown::InTables,
        read: |names| of_moving(names, Along::Travel, Kind::Length, false, |moving| {
            moving.carrier.front_view(&moving.axis).arm
        }),
    }
    SIDE_CENTRE: "instant centre in the side view" {
        name: "side_centre",
        sign: "x forward, z up",
        definition: "of the wheel's carrier in travel, in the plane y = constant through the wheel centre",
        source: "v + omega x r has no part in the plane",
        shown: Shown::InTables,
        read: |names| of_moving_place(names, Along::Travel, &[Axis::X, Axis::Z], |moving| {
            let InstantCentre { across, z, .. } = moving.carrier.side_view();
            Vector3::new(across, alone(f64::NAN), z)
        }),
    }
    SIDE_ARM: "swing arm in the side view" {
        name: "side_arm",
        sign: "positive where the instant centre lies behind",
        definition: "from the instant centre in the side view to the wheel centre, along x",
        source: "side-view swing-arm length",
        shown: Shown::InTables,
        read: |names| of_moving(names, Along::Travel, Kind::Length, false, |moving| {
            moving.carrier.side_view().arm
        }),
    }
    BRAKE_ANGLE: "support angle of outboard brakes" {
        name: "brake_angle",
        sign: "positive where the contact point moves forward in bump",
        definition: "of the path in travel of the contact point, as a point of the carrier, from the vertical in the \
                     side view, atan2(v_x, |v_z|) with v_z upwards; its tangent is anti-dive or anti-lift without the car's share",
        source: "side-view support angle, brake torque borne by the carrier",
        shown: Shown::InTables,
        read: |names| of_support_angle(names, Torque::OfBrakes),
    }
    DRIVE_ANGLE: "support angle of inboard drive" {
        name: "drive_angle",
        sign: "positive where the wheel centre moves forward in bump",
        definition: "of the path in travel of the wheel centre, from the vertical in the side view, atan2(v_x, |v_z|) \
                     with v_z upwards; its tangent is anti-squat without the car's share",
        source: "side-view support angle, drive torque borne by the chassis",
        shown: Shown::InTables,
        read: |names| of_support_angle(names, Torque::OfShafts),
    }
    ANTI_DIVE: "anti-dive" {
        name: "anti_dive",
        sign: "positive where braking pushes the front wheels down",
        definition: "of a front axle with outboard brakes, 100 tan(brake_angle) brake_share wheelbase / cg_height",
        source: "Gillespie 1992, chapter 7; shares and heights of [vehicle]",
        shown: Shown::InTables,
        read: |names| of_support(names, Axle::Front, Torque::OfBrakes, 1.0),
    }
    ANTI_LIFT: "anti-lift" {
        name: "anti_lift",
        sign: "positive where braking pulls the rear wheels up",
        definition: "of a rear axle with outboard brakes, -100 tan(brake_angle) brake_share wheelbase / cg_height",
        source: "Gillespie 1992, chapter 7; shares and heights of [vehicle]",
        shown: Shown::InTables,
        read: |names| of_support(names, Axle::Rear, Torque::OfBrakes, -1.0),
    }
    ANTI_SQUAT: "anti-squat" {
        name: "anti_squat",
        sign: "positive where driving pushes the rear wheels down",
        definition: "of a rear axle driven by shafts, -100 tan(drive_angle) drive_share wheelbase / cg_height",
        source: "Gillespie 1992, chapter 7; shares and heights of [vehicle]",
        shown: Shown::InTables,
        read: |names| of_support(names, Axle::Rear, Torque::OfShafts, -1.0),
    }
    ANTI_LIFT_IN_DRIVE: "anti-lift in drive" {
        name: "anti_lift_in_drive",
        sign: "positive where driving pulls the front wheels up",
        definition: "of a front axle driven by shafts, 100 tan(drive_angle) drive_share wheelbase / cg_height",
        source: "Gillespie 1992, chapter 7; shares and heights of [vehicle]",
        shown: Shown::InTables,
        read: |names| of_support(names, Axle::Front, Torque::OfShafts, 1.0),
    }
    TOE: "toe angle" {
        name: "toe",
        sign: "positive where the front of the wheel points inboard",
        definition: "of the spin axis from the y axis in the x-y plane, atan2(s_x, |s_y|)",
        source: "ISO 8855",
        shown: Shown::InBoth,
        read: |names| of_spin_axis(names, toe),
    }
    MEASURES: "measures" {
        name: "",
        sign: "",
        definition: "what the linkage measures; its derivative per drive is a motion ratio, negative where a length gets shorter",
        source: "`measure` of the listing",
        shown: Shown::InBoth,
        read: |names| {
            let measures = names.measures.iter();
            let measures = measures.map(|measure| (measure.name.as_str(), measure.kind.into()));
            each(measures, true, |state, measure| {
                state.measures.map(|measures| measures[measure])
            })
        },
    }
    ITERATIONS: "iterations of Newton's method" {
        name: "iterations",
        sign: "",
        definition: "from the instant before, steps in between included",
        source: "the solver",
        shown: Shown::InTables,
        read: |_| number(Kind::Count, |state| state.iterations as f64),
    }
    RESIDUAL: "largest residual" {
        name: "residual",
        sign: "",
        definition: "of any equation, (|d|^2 - L^2) / (2 L) of a length",
        source: "the solver",
        shown: Shown::InTables,
        read: |_| number(Kind::Length, |state| state.residual),
    }
}

/// What is read of each marker.
const RATES: [Kind; 3] = [Kind::Length, Kind::Velocity, Kind::Acceleration];

fn of_free_points(names: &Names, kind: Kind) -> Vec<Reading> {
    let free = names.chassis..names.chassis + names.free;
    free.flat_map(|index| point(names, index, kind)).collect()
}

/// A rate of the body that carries the wheel: one of its angular velocity and acceleration.
fn of_carrier(
    names: &Names,
    kind: Kind,
    which: fn([Vector3<f64>; 2]) -> Vector3<f64>,
) -> Vec<Reading> {
    let Some(WheelPoints { carrier, .. }) = names.wheel else {
        return Vec::new();
    };
    vector(None, kind, &Axis::ALL, move |state| {
        which(rotation(state, carrier))
    })
}

/// Angular velocity and acceleration of the body of three points; not finite where they are in line.
fn rotation(state: &State, body: [usize; 3]) -> [Vector3<f64>; 2] {
    let points = &state.points;
    let [at, rates, seconds] =
        [&points.value, &points.rate, &points.second_rate].map(|all| body.map(|point| all[point]));
    let omega = angular_velocity(&at, &rates);
    let alpha = omega.and_then(|omega| angular_acceleration(&at, &omega, &seconds));
    [omega, alpha].map(|found| found.unwrap_or_else(|| Vector3::repeat(f64::NAN)))
}

#[cfg(test)]
mod tests;
