//! Times that run backwards, stand still or are not finite, and drives at the ends of their range.

use nalgebra::Vector3;
use suspension_core::linkage::{Named, Values};
use suspension_core::linkages::five_link::{Drives, Model, Points};
use suspension_core::{
    Bounded, Build, Inputs, Linkage, Motion, Newton, Signal, SolveError, Tangent, Tracker, assemble,
};

use super::verdict::{demand_cause, demand_untouched};
use crate::support::{five_link_inputs, five_link_model, five_link_rough, motions};

fn begun() -> (Model<f64>, Motion<f64, 15>) {
    let model = five_link_model();
    let start = motions(&model, &five_link_rough(), five_link_inputs)[4];
    (model, start)
}

#[test]
fn a_motion_forth_and_back_returns_to_its_start() {
    let (model, start) = begun();
    let mut motion = start;
    for (from, to) in [(1.0, 1.9), (1.9, 0.0), (0.0, 1.0)] {
        Tracker::default()
            .advance(&model, five_link_inputs, from, to, &mut motion)
            .expect("a regular motion, either way");
    }
    assert!((motion.position - start.position).amax() < 1e-14);
    assert!((motion.velocity - start.velocity).amax() < 1e-12);
}

#[test]
fn a_step_of_zero_length_keeps_the_motion() {
    let (model, start) = begun();
    let inputs = five_link_inputs(1.0);
    let close = |motion: &Motion<f64, 15>| {
        assert!((motion.position - start.position).amax() < 1e-15);
        assert!((motion.velocity - start.velocity).amax() < 1e-13);
    };
    let (mut tracked, mut bounded, mut advanced) = (start, start, start);
    let tracker = Tracker::default();
    tracker
        .step(&model, &inputs, 0.0, &mut tracked)
        .expect("stays");
    Bounded::<f64>::default()
        .step(&model, &inputs, 0.0, &mut bounded)
        .expect("stays");
    tracker
        .advance(&model, five_link_inputs, 1.0, 1.0, &mut advanced)
        .expect("stays");
    for motion in [tracked, bounded, advanced] {
        close(&motion);
    }
}

/// Halving a step that is not finite ends for any number of allowed steps.
#[test]
fn an_advance_between_non_finite_times_ends_at_once() {
    let (model, start) = begun();
    let tracker = Tracker {
        max_steps: usize::MAX,
        ..Tracker::default()
    };
    for (from, to) in [
        (f64::NAN, 2.0),
        (1.0, f64::NAN),
        (1.0, f64::INFINITY),
        (1.0, f64::NEG_INFINITY),
        (f64::INFINITY, 1.0),
        (f64::NAN, f64::NAN),
    ] {
        let mut motion = start;
        let stopped = tracker
            .advance(&model, five_link_inputs, from, to, &mut motion)
            .expect_err("no such time");
        let (_, error) = stopped.refused.expect("a reason");
        assert_eq!(error, SolveError::StepNotFinite);
        demand_untouched(&start, &motion);
    }
}

/// The lower leading link along the axis that its angle is measured from: the drive moves nothing
/// there, and its rate is of no use.
#[test]
fn a_rate_at_the_end_of_a_driven_angle_is_refused_as_singular() {
    let rough = five_link_rough::<f64>();
    for (theta, up) in [(0.0, 0.4), (std::f64::consts::PI, -0.4)] {
        let by = rough.lower_front_inner + Vector3::new(0.0, 0.0, up) - rough.lower_front_outer;
        let mut values = rough.values();
        let design = Points::from_fn(|name| {
            let point = values.next().expect("as many as names");
            if name.ends_with("inner") {
                point
            } else {
                point + by
            }
        });
        let model = Model::new(&design).expect("a linkage");
        assert!((model.drives_at(&design).theta - theta).abs() < 1e-12);
        let inputs = Inputs::still(Signal {
            value: Drives { theta },
            rate: Drives { theta: 0.5 },
            second_rate: Drives { theta: 0.0 },
        });
        let q = model.unknowns(&design);
        let error = Tangent::new(&model, &inputs, &q).expect_err("no velocity");
        assert!(matches!(error, SolveError::Singular { .. }), "{error}");
        let start = Motion::at_rest(q);
        let (mut tracked, mut bounded) = (start, start);
        for error in [
            Tracker::default()
                .step(&model, &inputs, 1e-3, &mut tracked)
                .err(),
            Bounded::<f64>::default()
                .step(&model, &inputs, 1e-3, &mut bounded)
                .err(),
        ] {
            demand_cause(&model, &error.expect("no step"));
        }
        demand_untouched(&start, &tracked);
        demand_untouched(&start, &bounded);
    }
}

#[test]
fn links_that_cannot_reach_are_refused() {
    let model = five_link_model::<f64>();
    let mut lengths = model.lengths();
    // Its ends are held within two metres of each other by the rest.
    lengths.track_rod = 5.0;
    let model = model.with_lengths(&lengths).expect("positive lengths");
    let guess = model.unknowns(&five_link_rough());
    for inputs in [five_link_inputs(0.0), five_link_inputs(1.0)] {
        let mut q = guess;
        let error = assemble(&Newton::from_afar(), &model, &inputs, &mut q);
        let error = error.expect_err("out of reach");
        demand_cause(&model, &error);
        assert_eq!(q, guess);
    }
}
