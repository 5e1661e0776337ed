//! The strut's top is on the knuckle's line; the knuckle moves as top mount, arm and tie rod let it.

use super::layout::{Layout, TRAVEL};
use super::twist::{Twist, about};

const HINGE: [&str; 2] = ["lower_front", "lower_rear"];

#[test]
fn the_strut_line_does_not_pass_through_the_lower_ball_joint() {
    let layout = Layout::read("macpherson");
    let [ball, low, top] = ["lower_ball", "strut_low", "top"].map(|point| layout.at(point));
    let line = (top - low).normalize();
    assert!(line.cross(&(ball - low)).norm() > 0.02);
}

#[test]
fn the_knuckle_velocity_satisfies_top_mount_arm_and_tie_rod() {
    let layout = Layout::read("macpherson");
    for bump in TRAVEL {
        for steer in [-0.06, 0.0, 0.06] {
            let pose = layout.moved(&[("bump", bump), ("steer", steer)]);
            let [ball, tie, low, high] =
                ["lower_ball", "tie_ball", "strut_low", "strut_high"].map(|point| pose.at(point));
            let (top, rack) = (pose.at("top"), pose.at("rack"));
            let twist = Twist::default()
                .only_along(top, high - low)
                .only_along(ball, about(&layout, HINGE, ball))
                .along(tie, tie - rack, 0.0, 0.0)
                .without_arm();
            let points = ["lower_ball", "tie_ball", "strut_low", "strut_high", "axle"];
            twist.moves(&pose, &points);
            let damper = (top - low).norm();
            assert!((pose.measure("damper") - damper).abs() < 1e-14);
        }
    }
}

/// The rack is behind the axle: to the left it pushes the rear of the left wheel outboard.
#[test]
fn the_rack_behind_the_axle_gives_toe_and_camber_their_signs() {
    let layout = Layout::read("macpherson");
    let at = |bump, steer| layout.moved(&[("bump", bump), ("steer", steer)]).wheel;
    assert!(at(0.0, 0.06).toe > 0.3 && at(0.0, -0.06).toe < -0.3);
    assert!(at(0.03, 0.0).camber < 0.0 && at(-0.03, 0.0).camber > 0.0);
    assert!(at(0.06, 0.0).toe.abs() < 0.01 && at(-0.06, 0.0).toe.abs() < 0.01);
}
