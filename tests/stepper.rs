//! One trait over all steppers: the same calls, the same report, the same motion.

use std::cell::RefCell;

use suspension_core::linkages::five_link::Model;
use suspension_core::signal::ChassisMotion;
use suspension_core::solve::report::Report;
use suspension_core::step::series::SeriesTracker;
use suspension_core::{Bounded, Inputs, Linkage, Motion, SolveError, Stepper, Tracker};

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

/// A bounded step that records the length of each attempt, and whether it succeeded.
#[derive(Default)]
struct Recorded(RefCell<Vec<(f64, bool)>>);

impl Stepper<f64> for Recorded {
    fn step<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: &Inputs<C, L::Drives>,
        dt: f64,
        motion: &mut Motion<f64, N>,
    ) -> Result<Report<f64>, SolveError<f64>>
    where
        L: Linkage<N, Scalar = f64>,
        C: ChassisMotion<L::Fixed>,
    {
        let stepped = Stepper::step(&Bounded::<f64, 3>::new(), linkage, inputs, dt, motion);
        self.0.borrow_mut().push((dt, stepped.is_ok()));
        stepped
    }
}

/// A refusal takes much longer than a step.
#[test]
fn a_length_that_was_refused_is_not_tried_after_one_good_step() {
    let way = Recorded::default();
    let model: Model<f64> = support::five_link_model();
    let mut motion = support::five_link_start(&model);
    way.advance(&model, support::five_link_inputs, [0.0, 1.9], &mut motion)
        .expect("an advance");
    let attempts = way.0.into_inner();
    let mut after_refusals = 0;
    for three in attempts.windows(3) {
        if let &[(refused, false), (_, true), (next, _)] = three {
            after_refusals += 1;
            assert!(next < 0.75 * refused, "{refused} s, then {next} s");
        }
    }
    assert!(after_refusals > 1);
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
