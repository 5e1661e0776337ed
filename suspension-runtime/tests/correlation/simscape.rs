//! Simscape Multibody, the K&C rigs of its vehicle templates, with the formulas of their
//! `sm_car_knc_calc_susp_metrics`: caster and kingpin angle are secants between toe of one degree either way at a
//! held height of the wheel centre, rates are secants over 10 mm of travel either way.

mod formula_student;
mod virtual_axes;

use nalgebra::Vector3;
use suspension_core::body::pose;
use suspension_core::wheel::toe;

use crate::suspension::{Moving, Position, values};

/// The height of the rates, m either way.
const TRAVEL: f64 = 0.010;

/// Half a unit of the last of so many significant digits.
fn printed(value: f64, digits: i32) -> f64 {
    let leading = value.abs().log10().floor() as i32;
    0.5 * 10_f64.powi(leading + 1 - digits)
}

/// With the wheel at a height from the design and a toe angle in radians.
fn steered<'l>(design: &Position<'l>, bump: f64, angle: f64) -> Moving<'l> {
    let mut rack = 0.0;
    for _ in 0..8 {
        let toe = toe(&design.moved([bump, rack]).in_steering().spin_axis());
        rack -= (toe.value - angle) / toe.rate;
    }
    design.moved([bump, rack]).in_bump()
}

/// Where a unit vector points, in the terms of a wheel on the left.
struct Direction {
    /// From outboard to the front.
    toe: f64,
    /// Above the ground.
    elevation: f64,
}

impl Direction {
    fn of(v: &Vector3<f64>) -> Self {
        Self {
            toe: v.x.atan2(v.y),
            elevation: v.z.atan2(v.xy().norm()),
        }
    }
}

/// The steering axis, radians.
struct Axis {
    caster: f64,
    kingpin: f64,
    camber_per_toe: f64,
}

impl Axis {
    /// From the spin axis and the carrier's x axis with toe of a degree either way; the carrier by three points.
    fn at(design: &Position<'_>, body: [&str; 3], bump: f64) -> Self {
        let points = |moving: &Moving<'_>| body.map(|name| values(&moving.point(name)));
        let from = points(&design.in_bump());
        let [inward, outward] = [1.0_f64, -1.0].map(|degrees| {
            let moving = steered(design, bump, degrees.to_radians());
            let turn = pose(&from, &points(&moving)).expect("three points not in line");
            let spin = Direction::of(&values(&moving.spin_axis()));
            (spin, Direction::of(&(turn.rotation * Vector3::x())))
        });
        let rises = |of: [&Direction; 2]| of[0].elevation.sin() - of[1].elevation.sin();
        let across = |of: [&Direction; 2]| of[0].toe.sin() - of[1].toe.sin();
        let along = |of: [&Direction; 2]| of[0].toe.cos() - of[1].toe.cos();
        let spin = [&inward.0, &outward.0];
        let x = [&inward.1, &outward.1];
        let tangent = rises(spin) / across(spin);
        Self {
            caster: tangent.atan(),
            // An axis that both vectors keep their angles to has -tangent here; the published formula has not.
            kingpin: ((tangent * across(x) + rises(x)) / along(x)).atan(),
            camber_per_toe: -(spin[0].elevation - spin[1].elevation) / (spin[0].toe - spin[1].toe),
        }
    }
}

/// Degrees of caster per metre of travel.
fn bump_caster(design: &Position<'_>, body: [&str; 3]) -> f64 {
    let caster = |bump| Axis::at(design, body, bump).caster.to_degrees();
    (caster(TRAVEL) - caster(-TRAVEL)) / (2.0 * TRAVEL)
}
