//! A double wishbone with rack steering.

use nalgebra::Vector3;
use suspension_core::{Build, Inputs, Linkage, Motion, Signal, Tracker};

use super::checks;
use crate::double_wishbone::design;
use crate::double_wishbone::listing::{Drives, Model, Points};

#[test]
fn derivatives_and_motion_with_a_steering_rack_agree() {
    let model = Model::new(&design()).expect("a double wishbone");
    checks::derivatives(&model, &design());
    let drives = |t| checks::swinging(model.drives_at(&design()), 0.02, t);
    checks::motion(&model, &design(), |t| Inputs::still(drives(t)));
    let heaving = |t| Inputs {
        chassis: checks::heaving(model.fixed(), 0.01, t),
        drives: drives(t),
    };
    checks::motion(&model, &design(), heaving);
}

/// Bump and steer that swing near a singularity of the linkage: one call over the whole time arrives
/// where many small ones do, in no other assembly.
#[test]
fn one_long_advance_near_singularities_stays_in_the_assembly() {
    let at = Vector3::new;
    let design = Points {
        lower_front: at(0.20, 0.35, 0.16),
        lower_rear: at(-0.20, 0.35, 0.16),
        upper_front: at(0.15, 0.42, 0.42),
        upper_rear: at(-0.15, 0.42, 0.42),
        rack: at(0.11, 0.34, 0.20),
        lower_ball: at(0.005, 0.70, 0.17),
        upper_ball: at(-0.015, 0.66, 0.44),
        tie_ball: at(0.12, 0.68, 0.21),
        axle_inner: at(0.0, 0.65, 0.30),
        axle_outer: at(0.0, 0.75, 0.30),
    };
    let model = Model::new(&design).expect("a geometry");
    let start = model.drives_at(&design);
    let phase: f64 = 3941.0 * 0.37;
    let inputs = |t: f64| {
        let (bump, steer) = (0.1358, 0.0679);
        let swing = 3.0 * t + phase;
        Inputs::still(Signal {
            value: Drives {
                bump: start.bump + bump * (swing.sin() - phase.sin()),
                steer: start.steer + steer * (2.1 * t).sin(),
            },
            rate: Drives {
                bump: 3.0 * bump * swing.cos(),
                steer: 2.1 * steer * (2.1 * t).cos(),
            },
            second_rate: Drives {
                bump: -9.0 * bump * swing.sin(),
                steer: -4.41 * steer * (2.1 * t).sin(),
            },
        })
    };
    let tracker = Tracker {
        max_steps: 100_000,
        ..Tracker::default()
    };
    let travel = |calls: u32| {
        let mut motion = Motion::at_rest(model.unknowns(&design));
        let end = |call: u32| 17.1 * f64::from(call) / f64::from(calls);
        (0..calls)
            .try_for_each(|call| {
                let advanced =
                    tracker.advance(&model, inputs, end(call), end(call + 1), &mut motion);
                advanced.map(drop)
            })
            .map(|()| motion.position)
    };
    let expected = travel(1710).expect("small steps pass");
    for calls in [1, 10, 100] {
        let position = travel(calls).expect("calls are stepped through");
        let difference = (position - expected).amax();
        assert!(difference < 1e-9, "{calls} calls: {difference:e} m");
    }
}
