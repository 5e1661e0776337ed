//! Both listings of the published mechanism against its solution in 40-digit arithmetic.

use suspension_core::linkage::HasWheel;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::wheel::CarrierRotation;
use suspension_core::{Inputs, Linkage, Motion, Still, Tracker};

use crate::support::{self, INSTANTS, Reference};

/// The bounds on the largest differences: positions in m, velocities in m/s, accelerations in
/// m/s^2, angular velocity in rad/s, angular acceleration in rad/s^2.
const BOUNDS: [f64; 5] = [5e-15, 1e-12, 1e-10, 1e-11, 1e-9];

fn differences<L>(
    model: &L,
    inputs: impl Fn(f64) -> Inputs<Still, L::Drives>,
    motions: &[Motion<f64, 15>],
) -> [f64; 5]
where
    L: Linkage<15, Scalar = f64, Points: HasWheel<f64>>,
{
    let reference = Reference::load();
    let mut worst = [0.0_f64; 5];
    for (instant, motion) in motions.iter().enumerate() {
        let points = motion.points(model, &inputs(INSTANTS[instant]));
        let rotation = CarrierRotation::of(&points.map(|points| points.carrier()))
            .expect("points 6 to 8 form a triangle");
        let CarrierRotation { omega, alpha } = rotation;
        let found = [
            (motion.position - reference.unknowns(instant, "")).amax(),
            (motion.velocity - reference.unknowns(instant, "v")).amax(),
            (motion.acceleration - reference.unknowns(instant, "a")).amax(),
            (omega - reference.vector(instant, "omega_")).amax(),
            (alpha - reference.vector(instant, "alpha_")).amax(),
        ];
        for (worst, found) in worst.iter_mut().zip(found) {
            *worst = worst.max(found);
        }
    }
    println!("largest differences: {worst:?}");
    worst
}

fn assert_within_bounds(found: [f64; 5]) {
    for (found, bound) in found.iter().zip(BOUNDS) {
        assert!(*found <= bound, "{found:e} > {bound:e}");
    }
}

#[test]
fn attia2003_agrees_with_the_40_digit_solution() {
    let model: attia2003::Model<f64> = support::attia_model();
    let motions = support::motions(&model, &support::attia_rough(), support::attia_inputs);
    assert_within_bounds(differences(&model, support::attia_inputs, &motions));
}

#[test]
fn five_link_agrees_with_the_40_digit_solution() {
    let model: five_link::Model<f64> = support::five_link_model();
    let motions = support::motions(
        &model,
        &support::five_link_rough(),
        support::five_link_inputs,
    );
    assert_within_bounds(differences(&model, support::five_link_inputs, &motions));
}

/// f32 about the paper's origin, 1.4 m away: rounding of the coordinates alone is 6e-8 m, and
/// the condition number of up to 517 multiplies what the equations lose.
#[test]
fn f32_positions_agree_with_the_40_digit_solution() {
    let model: attia2003::Model<f32> = support::attia_model();
    let motions = support::motions(&model, &support::attia_rough(), support::attia_inputs);
    let reference = Reference::load();
    for (instant, motion) in motions.iter().enumerate() {
        let position = motion.position.map(f64::from);
        let difference = (position - reference.unknowns(instant, "")).amax();
        assert!(difference <= 5e-6, "instant {instant}: {difference:e} m");
    }
}

/// The control loop in single precision: a step each millisecond over the whole motion.
#[test]
fn f32_steps_of_one_millisecond_follow_the_published_motion() {
    let model: attia2003::Model<f32> = support::attia_model();
    let mut motion = support::motions(&model, &support::attia_rough(), support::attia_inputs)[0];
    let tracker = Tracker::<f32>::default();
    for millisecond in 1..=1950 {
        let inputs = support::attia_inputs(millisecond as f32 * 1e-3);
        let step = tracker.step(&model, &inputs, 1e-3, &mut motion);
        step.unwrap_or_else(|error| panic!("at {millisecond} ms: {error}"));
    }
    let difference = motion.position.map(f64::from) - Reference::load().unknowns(8, "");
    assert!(difference.amax() <= 5e-6, "{:e} m", difference.amax());
}
