//! A rocker on two chassis points: a rotation about the line through them.

use nalgebra::{Rotation3, Unit, Vector3};
use suspension_core::Build;

use super::checks;

suspension_core::linkage! {
    /// Push rod and spring on one rocker.
    mod rocker {
        fixed: front, rear;
        free:  push, pull;
        body bell_crank: push, pull, front, rear;
        drive lift: push.z;
        point mark: bell_crank;
    }
}

use rocker::{Drives, Model, Points};

fn design() -> Points<f64> {
    Points {
        front: Vector3::new(0.10, 0.02, 0.50),
        rear: Vector3::new(-0.08, 0.05, 0.53),
        push: Vector3::new(0.03, 0.15, 0.55),
        pull: Vector3::new(-0.01, 0.08, 0.63),
        mark: Vector3::new(0.02, 0.12, 0.60),
    }
}

/// The rocker turned by an angle.
fn turned(angle: f64) -> Points<f64> {
    let design = design();
    let axis = Unit::new_normalize(design.rear - design.front);
    let turn = Rotation3::from_axis_angle(&axis, angle);
    let about = |point: Vector3<f64>| design.front + turn * (point - design.front);
    Points {
        push: about(design.push),
        pull: about(design.pull),
        mark: about(design.mark),
        ..design
    }
}

#[test]
fn a_rocker_turns_about_its_axis() {
    let model = Model::new(&design()).expect("a rocker");
    for angle in [-0.5, -0.1, 0.0, 0.2, 0.4] {
        let expected = turned(angle);
        let drives = Drives {
            lift: expected.push.z,
        };
        let solved = checks::solve(&model, &turned(0.9 * angle), drives);
        assert!(
            checks::largest_distance(&solved, &expected) < 1e-14,
            "at {angle} rad"
        );
    }
}

#[test]
fn derivatives_and_motion_agree_with_differences() {
    let model = Model::new(&design()).expect("a rocker");
    checks::derivatives_and_motion(&model, &design(), 0.03);
}
