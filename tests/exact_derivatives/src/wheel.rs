//! Quantities of a wheel from its points and velocities, in 32 digits.

use std::f64::consts::TAU;

use nalgebra::Vector3;
use suspension_core::signal::Number as _;
use suspension_core::wheel::{
    Carrier, Heading, SteeringAxis, camber, camber_to_ground, caster, contact, kingpin_angle, toe,
};
use suspension_double_double::DoubleDouble as Number;

pub(super) type Vector = Vector3<Number>;

/// Numbers under their names.
pub(super) type Named = Vec<(String, Number)>;

/// Wheel radius, m.
pub(super) const RADIUS: f64 = 0.3;

/// The travel of the rack per turn of the steering wheel, m.
pub(super) const PER_TURN: f64 = 0.052;

pub(super) fn on_ground([inner, centre]: [Vector; 2]) -> Vector {
    contact(&centre, &(centre - inner), RADIUS.into())
}

pub(super) fn coordinates(named: &mut Named, name: &str, at: &Vector) {
    for (axis, value) in ["x", "y", "z"].into_iter().zip(at.iter()) {
        named.push((format!("{name}_{axis}"), *value));
    }
}

pub(super) fn of_wheel(
    named: &mut Named,
    [inner, centre]: [Vector; 2],
    kingpin: Option<[Vector; 2]>,
) {
    let axis = centre - inner;
    let ground = contact(&centre, &axis, RADIUS.into());
    coordinates(named, "contact", &ground);
    let mut add = |name: &str, value| named.push((name.to_owned(), value));
    add("camber_rad", camber(&axis));
    add("camber_to_ground_rad", camber_to_ground(&axis));
    add("toe_rad", toe(&axis));
    let Some([lower, upper]) = kingpin else {
        return;
    };
    let heading = Heading::of(&axis);
    let line = SteeringAxis::through([lower, upper]);
    add("kingpin_rad", kingpin_angle(&line.direction, &axis));
    add("caster_rad", caster(&line.direction));
    add("scrub_radius_m", line.inboard_of(&ground, &heading));
    add("mechanical_trail_m", line.ahead_of(&ground, &heading));
    add("kingpin_offset_m", line.inboard_of(&centre, &heading));
    add("caster_offset_m", line.ahead_of(&centre, &heading));
}

pub(super) fn of_steering(
    named: &mut Named,
    carrier: &Carrier<Number>,
    [inner, centre]: [Vector; 2],
) {
    let Carrier {
        velocity, omega, ..
    } = carrier;
    let axis = centre - inner;
    let ground = contact(&centre, &axis, RADIUS.into());
    let heading = Heading::of(&axis);
    let screw = SteeringAxis::of_screw(&centre, velocity, omega);
    let pitch = omega.dot(velocity) / omega.dot(omega);
    let axis_rate = omega.cross(&axis);
    let steer_rate =
        (axis.x * axis_rate.y - axis.y * axis_rate.x) / (axis.x * axis.x + axis.y * axis.y);
    let ratio = Number::from(TAU / PER_TURN) / steer_rate;
    named.extend(
        [
            (
                "virtual_kingpin_rad",
                kingpin_angle(&screw.direction, &axis),
            ),
            ("virtual_caster_rad", caster(&screw.direction)),
            (
                "virtual_scrub_radius_m",
                screw.inboard_of(&ground, &heading),
            ),
            ("virtual_trail_m", screw.ahead_of(&ground, &heading)),
            ("virtual_pitch_m_rad", pitch),
            (
                "steering_ratio_rad_rad",
                // It is positive for every suspension of the catalogue.
                if ratio.is_below_zero() { -ratio } else { ratio },
            ),
        ]
        .map(|(name, value)| (name.to_owned(), value)),
    );
}

/// The motion of a wheel's carrier from three of its points: for rigid edges `a` and `b` with rates `a'` and `b'`, and `n =
/// a x b`, the angular velocity is `(a (b' . n) - b (a' . n) + n (a' . b)) / |n|^2`.
pub(super) fn moving_carrier(
    points: [Vector; 3],
    rates: [Vector; 3],
    centre: Vector,
) -> Carrier<Number> {
    let [a, b] = [points[1] - points[0], points[2] - points[0]];
    let [da, db] = [rates[1] - rates[0], rates[2] - rates[0]];
    let normal = a.cross(&b);
    let turning = a * db.dot(&normal) - b * da.dot(&normal) + normal * da.dot(&b);
    let omega = turning / normal.dot(&normal);
    Carrier {
        centre,
        velocity: rates[0] + omega.cross(&(centre - points[0])),
        omega,
    }
}
