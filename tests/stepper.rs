//! One trait over all steppers: the same calls, the same report, the same motion.

use suspension_core::linkages::five_link::Model;
use suspension_core::step::series::SeriesTracker;
use suspension_core::{Bounded, Motion, Stepper, Tracker};

use super::support;

/// The motion that a way to step reaches after a second of the published motion, from the motion at its start.
fn second(way: &impl Stepper<f64>, tolerance: f64) -> Motion<f64, 15> {
    let model: Model<f64> = support::five_link_model();
    let mut motion = support::five_link_start(&model);
    way.step(&model, &support::five_link_inputs(0.0), 0.0, &mut motion)
        .expect("rates");
    for step in 1..=1000 {
        let inputs = support::five_link_inputs(f64::from(step) * 1e-3);
        let report = way
            .step(&model, &inputs, 1e-3, &mut motion)
            .expect("a step");
        assert!(report.residual() <= report.tolerance() && report.tolerance() <= tolerance);
        assert!(report.error() < 1e-6 && report.growth() > 1.0);
        assert_eq!((report.steps, report.iterations), (1, 1));
    }
    motion
}

#[test]
fn every_stepper_reaches_the_same_motion() {
    let tracked = second(&Tracker::default(), 1e-13);
    let bounded = second(&Bounded::default(), 1e-13);
    let series = second(&SeriesTracker::<f64, 6>::within(1e-12), 1e-12);
    for motion in [bounded, series] {
        assert!((motion.position - tracked.position).amax() < 1e-12);
        assert!((motion.velocity - tracked.velocity).amax() < 1e-9);
    }
}

#[test]
fn every_stepper_divides_a_long_advance() {
    fn advanced(way: &impl Stepper<f64>) -> Motion<f64, 15> {
        let model: Model<f64> = support::five_link_model();
        let mut motion = support::five_link_start(&model);
        let report = way
            .advance(&model, support::five_link_inputs, [0.0, 1.0], &mut motion)
            .expect("a second");
        assert!(report.steps > 1 && report.iterations >= report.steps);
        motion
    }
    let tracked = advanced(&Tracker::default());
    let bounded = advanced(&Bounded::<f64, 3>::new());
    assert!((tracked.position - bounded.position).amax() < 1e-13);
}

/// The type of the numbers comes from the model.
#[test]
fn a_bounded_step_infers_its_number_type_from_the_model() {
    let model: Model<f32> = support::five_link_model();
    let mut motion = support::five_link_start(&model);
    let inputs = support::five_link_inputs(0.0);
    Bounded::default()
        .step(&model, &inputs, 0.0, &mut motion)
        .expect("rates");
}
