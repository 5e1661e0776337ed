//! Ways from one input to another.

use nalgebra::SVector;
use suspension_core::linkages::five_link;
use suspension_core::{Inputs, Signal, Tracker};

use crate::support;

/// However far apart two inputs, sub-steps lead from one to the other, at rest or not.
#[test]
fn inputs_far_apart_are_joined_in_sub_steps() {
    let model: five_link::Model<f64> = support::five_link_model();
    let inputs = support::five_link_inputs::<f64>;
    let motions = support::motions(&model, &support::five_link_rough(), inputs);
    let tracker = Tracker::default();
    let join = |from: usize, to: usize, dt: f64| {
        let [first, last] = [from, to].map(|instant| inputs(support::INSTANTS[instant]));
        let mut motion = motions[from];
        let advanced = tracker
            .step_between(&model, [&first, &last], dt, &mut motion)
            .expect("a configuration within reach");
        let off: SVector<f64, 15> = motion.position - motions[to].position;
        assert!(off.amax() < 1e-13, "{from} to {to}: {} m", off.amax());
        let off = motion.acceleration - motions[to].acceleration;
        let size = motions[to].acceleration.amax();
        assert!(off.amax() < 1e-10 * size, "the rates are those of the end");
        advanced.steps
    };
    for (from, to) in [(0, 8), (8, 0), (2, 5), (7, 1), (3, 3)] {
        let dt = support::INSTANTS[to] - support::INSTANTS[from];
        let dt = if dt == 0.0 { 1e-3 } else { dt };
        let steps = [dt, 1e-3].map(|dt| join(from, to, dt));
        println!("from instant {from} to {to}: {steps:?} sub-steps");
    }
    let locked = Inputs::still(Signal {
        value: five_link::Drives { theta: 3.0 },
        ..Signal::default()
    });
    let mut motion = motions[0];
    let ends = [&inputs(0.0), &locked];
    let stopped = tracker.step_between(&model, ends, 1.0, &mut motion);
    assert!(stopped.is_err_and(|stopped| stopped.reached < 1.0));
    assert_eq!(motion, motions[0]);
}
