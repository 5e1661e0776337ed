//! Two bodies with a common edge: a semi-trailing arm that carries a flap.

use nalgebra::{Rotation3, Unit, Vector3};
use suspension_core::Build;

use super::checks;

suspension_core::linkage! {
    /// Semi-trailing arm with a flap hinged to it.
    mod semi_trailing {
        fixed: inner, outer;
        free:  hinge_in, hinge_out, centre, tip;
        hinge arm: inner, outer -> hinge_in, hinge_out, centre;
        body flap: tip, hinge_in, hinge_out;
        drive bump: centre.z;
        drive fold: tip.z - hinge_in.z;
        wheel: hinge_in -> centre;
    }
}

use semi_trailing::{Drives, Model, Points};

fn design() -> Points<f64> {
    Points {
        inner: Vector3::new(0.40, 0.20, 0.30),
        outer: Vector3::new(0.35, 0.55, 0.28),
        hinge_in: Vector3::new(0.05, 0.40, 0.32),
        hinge_out: Vector3::new(0.02, 0.60, 0.30),
        centre: Vector3::new(0.00, 0.72, 0.29),
        tip: Vector3::new(-0.15, 0.50, 0.35),
    }
}

/// `point` turned by `angle` about the line from `from` to `to`.
fn turn(point: Vector3<f64>, [from, to]: [Vector3<f64>; 2], angle: f64) -> Vector3<f64> {
    let axis = Unit::new_normalize(to - from);
    from + Rotation3::from_axis_angle(&axis, angle) * (point - from)
}

/// The arm turned about the chassis, the flap about the arm.
fn turned(arm: f64, flap: f64) -> Points<f64> {
    let design = design();
    let with_arm = |point| turn(point, [design.inner, design.outer], arm);
    let (hinge_in, hinge_out) = (with_arm(design.hinge_in), with_arm(design.hinge_out));
    Points {
        hinge_in,
        hinge_out,
        centre: with_arm(design.centre),
        tip: turn(with_arm(design.tip), [hinge_in, hinge_out], flap),
        ..design
    }
}

#[test]
fn arm_and_flap_turn_about_their_hinges() {
    let model = Model::new(&design()).expect("an arm with a flap");
    for (arm, flap) in [(0.0, 0.0), (0.2, -0.3), (-0.3, 0.4), (0.1, 0.8)] {
        let expected = turned(arm, flap);
        let drives = Drives {
            bump: expected.centre.z,
            fold: expected.tip.z - expected.hinge_in.z,
        };
        let solved = checks::solve(&model, &turned(0.9 * arm, 0.9 * flap), drives);
        assert!(
            checks::largest_distance(&solved, &expected) < 1e-14,
            "at {arm}, {flap} rad"
        );
    }
}

#[test]
fn the_carrier_of_the_wheel_is_the_frame_of_the_arm() {
    let points = design();
    let carrier = suspension_core::linkage::HasWheel::carrier(&points);
    // The frame of the body: chassis points first.
    assert_eq!(carrier, [points.inner, points.outer, points.hinge_in]);
}

#[test]
fn derivatives_and_motion_agree_with_differences() {
    let model = Model::new(&design()).expect("an arm with a flap");
    checks::derivatives_and_motion(&model, &design(), 0.03);
}
