//! A double wishbone with rack steering.

use nalgebra::Vector3;
use suspension_core::{Build, Inputs, Linkage, Motion, Signal, Tracker};

use super::checks;

suspension_core::linkage! {
    /// Double wishbone. Axes as ISO 8855.
    mod double_wishbone {
        fixed: lower_front, lower_rear, upper_front, upper_rear, rack;
        free:  lower_ball, upper_ball, tie_ball, axle_inner, axle_outer;

        link lower_fore: lower_front -> lower_ball;
        link lower_aft:  lower_rear  -> lower_ball;
        link upper_fore: upper_front -> upper_ball;
        link upper_aft:  upper_rear  -> upper_ball;
        link tie_rod:    rack        -> tie_ball;
        body upright:    lower_ball, upper_ball, tie_ball, axle_inner, axle_outer;

        drive bump:  axle_outer.z;
        drive steer: rack.y;

        wheel:   axle_inner -> axle_outer;
        kingpin: lower_ball -> upper_ball;
    }
}

use double_wishbone::{Drives, Model, Points};

/// Points of about the size of a passenger car's, metres.
fn design() -> Points<f64> {
    Points {
        lower_front: Vector3::new(0.15, 0.40, 0.18),
        lower_rear: Vector3::new(-0.20, 0.42, 0.19),
        upper_front: Vector3::new(0.10, 0.45, 0.55),
        upper_rear: Vector3::new(-0.15, 0.48, 0.56),
        rack: Vector3::new(-0.16, 0.38, 0.30),
        lower_ball: Vector3::new(0.01, 0.75, 0.15),
        upper_ball: Vector3::new(-0.02, 0.68, 0.56),
        tie_ball: Vector3::new(-0.14, 0.74, 0.31),
        axle_inner: Vector3::new(0.0, 0.66, 0.33),
        axle_outer: Vector3::new(0.0, 0.76, 0.33),
    }
}

#[test]
fn derivatives_and_motion_with_a_steering_rack() {
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

/// Bump and steer that swing near a singularity of the linkage: one call over the whole time, as
/// many small ones, or none at all, but never another assembly.
#[test]
fn a_long_way_past_singularities_stays_in_the_assembly() {
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
        if let Ok(position) = travel(calls) {
            let difference = (position - expected).amax();
            assert!(difference < 1e-9, "{calls} calls: {difference:e} m");
        }
    }
}
