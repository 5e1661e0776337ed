//! Lines at angles: two cranks on parallel axes at a held angle turn together; measured angles.

use nalgebra::{Rotation3, Vector3};
use suspension_core::{Build, Linkage, Signal, Values};

use super::checks;

suspension_core::linkage! {
    mod cranks {
        fixed: first_rear, first_front, second_rear, second_front, rest;
        free:  first, second;
        hinge first_crank:  first_rear, first_front -> first;
        hinge second_crank: second_rear, second_front -> second;
        angle chain: first_rear -> first, second_front -> second;
        drive lift:  first.z;
        measure turn:  angle(first_front -> rest, first_front -> first about first_rear -> first_front);
        measure apart: angle(first_rear -> first, second_front -> second);
        measure from_rest: angle(rest -> first_rear, rest -> second);
    }
}
use cranks::{Drives, Model, Points};

fn design() -> Points<f64> {
    let first = Vector3::new(0.1, 0.5, 0.25);
    Points {
        first_rear: Vector3::new(0.0, 0.2, 0.2),
        first_front: Vector3::new(0.3, 0.2, 0.2),
        second_rear: Vector3::new(-0.1, -0.3, 0.4),
        second_front: Vector3::new(0.2, -0.3, 0.4),
        rest: first,
        first,
        second: Vector3::new(0.05, -0.25, 0.8),
    }
}

/// Both cranks turned by an angle that changes at a rate and a second rate.
fn turning([angle, rate, second_rate]: [f64; 3]) -> Signal<Points<f64>> {
    let design = design();
    let turn = Rotation3::from_axis_angle(&Vector3::x_axis(), angle);
    let about = |centre: Vector3<f64>, point: Vector3<f64>| turn * (point - centre);
    let arms = [
        about(design.first_rear, design.first),
        about(design.second_rear, design.second),
    ];
    let at_rest = |arms: [Vector3<f64>; 2]| {
        let [first, second] = arms;
        let still = Points::from_values([]);
        Points {
            first,
            second,
            ..still
        }
    };
    let x = Vector3::x();
    let [first, second] = arms;
    Signal {
        value: Points {
            first: design.first_rear + first,
            second: design.second_rear + second,
            ..design
        },
        rate: at_rest(arms.map(|arm| x.cross(&arm) * rate)),
        second_rate: at_rest(
            arms.map(|arm| x.cross(&arm) * second_rate + x.cross(&x.cross(&arm)) * (rate * rate)),
        ),
    }
}

#[test]
fn two_cranks_at_a_held_angle_turn_together() {
    let model = Model::new(&design()).expect("two cranks");
    let again = model.with_lengths(&model.lengths()).expect("the same");
    for model in [model, again] {
        for angle in [-0.4, -0.1, 0.0, 0.3] {
            let expected = turning([angle, 0.0, 0.0]).value;
            let drives = Drives {
                lift: expected.first.z,
            };
            checks::meets(&model, &design(), drives, &expected, 1e-13);
        }
    }
}

#[test]
fn derivatives_and_motion_agree_with_differences() {
    let model = Model::new(&design()).expect("two cranks");
    checks::derivatives_and_motion(&model, &design(), 0.03);
}

/// The angle about the axis passes through zero with its rates; that between lines which turn together rests.
#[test]
fn measured_angles_and_rates_match_the_rotation() {
    let model = Model::new(&design()).expect("two cranks");
    let start = model.measures(&Signal::still(design())).value.apart;
    for angle in [-3.0, -0.5, 0.0, 0.2, 2.0] {
        let of = [angle, 0.7, -0.3];
        let found = model.measures(&turning(of));
        let turn = [found.value.turn, found.rate.turn, found.second_rate.turn];
        for (found, expected) in turn.into_iter().zip(of) {
            assert!((found - expected).abs() < 1e-14, "{found} for {expected}");
        }
        let apart = [
            found.value.apart - start,
            found.rate.apart,
            found.second_rate.apart,
        ];
        assert!(apart.into_iter().all(|off| off.abs() < 1e-14), "{apart:?}");
    }
}
