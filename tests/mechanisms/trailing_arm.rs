//! A trailing arm on two chassis points, driven by its angle: a rotation about the line through
//! them.

use nalgebra::{Rotation3, Unit, Vector3};
use suspension_core::Build;

use super::checks;

suspension_core::linkage! {
    /// The angle runs from a chassis point to the hub.
    mod trailing_arm {
        fixed: inner, outer;
        free:  hub, brake;
        body arm: inner, outer, hub, brake;
        drive turn: angle(inner -> hub, z);
    }
}

suspension_core::linkage! {
    /// The angle runs from the hub, and the body lists its points in another order.
    mod backwards {
        fixed: inner, outer;
        free:  hub, brake;
        body arm: hub, brake, outer, inner;
        drive turn: angle(hub -> outer, z);
    }
}

use trailing_arm::{Drives, Model, Points};

/// The axis is neither square to the arm nor along one of the coordinates.
const INNER: Vector3<f64> = Vector3::new(0.40, 0.20, 0.30);
const OUTER: Vector3<f64> = Vector3::new(0.36, 0.55, 0.28);
const HUB: Vector3<f64> = Vector3::new(0.00, 0.60, 0.25);
const BRAKE: Vector3<f64> = Vector3::new(0.05, 0.52, 0.35);

/// A point of the arm turned by `angle` about the axis.
fn turned(point: Vector3<f64>, angle: f64) -> Vector3<f64> {
    let axis = Unit::new_normalize(OUTER - INNER);
    INNER + Rotation3::from_axis_angle(&axis, angle) * (point - INNER)
}

fn arm(angle: f64) -> Points<f64> {
    Points {
        inner: INNER,
        outer: OUTER,
        hub: turned(HUB, angle),
        brake: turned(BRAKE, angle),
    }
}

const ANGLES: [f64; 5] = [-0.4, -0.1, 0.0, 0.2, 0.5];

#[test]
fn an_arm_turns_to_the_driven_angle() {
    let model = Model::new(&arm(0.0)).expect("an arm");
    for angle in ANGLES {
        let expected = arm(angle);
        let turn = (expected.hub - INNER).angle(&Vector3::z());
        let solved = checks::solve(&model, &arm(angle - 0.05), Drives { turn });
        assert!(
            checks::largest_distance(&solved, &expected) < 1e-14,
            "at {angle} rad"
        );
        assert!((model.drives_at(&solved).turn - turn).abs() < 1e-14);
    }
}

#[test]
fn an_arm_turns_to_the_angle_of_the_reversed_line() {
    let points = |angle| backwards::Points {
        inner: INNER,
        outer: OUTER,
        hub: turned(HUB, angle),
        brake: turned(BRAKE, angle),
    };
    let model = backwards::Model::new(&points(0.0)).expect("an arm");
    for angle in ANGLES {
        let expected = points(angle);
        let turn = (OUTER - expected.hub).angle(&Vector3::z());
        let solved = checks::solve(&model, &points(angle - 0.05), backwards::Drives { turn });
        assert!(
            checks::largest_distance(&solved, &expected) < 1e-14,
            "at {angle} rad"
        );
    }
}

/// Longer lengths bring a new angle scale with them.
#[test]
fn a_driven_angle_uses_the_changed_length() {
    let model = Model::new(&arm(0.0)).expect("an arm");
    let mut lengths = model.lengths();
    lengths.arm_inner_hub += 0.02;
    let model = model.with_lengths(&lengths).expect("an arm");
    let solved = checks::solve(&model, &arm(0.0), Drives { turn: 1.6 });
    let along = solved.hub - INNER;
    assert!((along.norm() - lengths.arm_inner_hub).abs() < 1e-14);
    assert!((along.angle(&Vector3::z()) - 1.6).abs() < 1e-14);
}

#[test]
fn derivatives_and_motion_agree_with_differences() {
    let model = Model::new(&arm(0.1)).expect("an arm");
    checks::derivatives_and_motion(&model, &arm(0.1), 0.05);
}
