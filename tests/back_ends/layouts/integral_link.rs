//! The upright moves as arm, integral link, camber link and toe link let it, and hardly pitches.

use super::layout::{Layout, TRAVEL};
use super::twist::{Twist, about};

const HINGE: [&str; 2] = ["lower_front", "lower_rear"];
const LINKS: [[&str; 2]; 2] = [["camber_inner", "camber_ball"], ["toe_inner", "toe_ball"]];

#[test]
fn the_upright_velocity_satisfies_its_arm_and_links() {
    let layout = Layout::read("integral_link");
    for bump in TRAVEL {
        let pose = layout.moved(&[("bump", bump)]);
        let ball = pose.at("lower_ball");
        let arm = about(&layout, HINGE, ball);
        let [low, high] = ["integral_lower", "integral_upper"].map(|point| pose.at(point));
        let start = Twist::default()
            .only_along(ball, arm)
            .along(
                high,
                high - low,
                (high - low).dot(&about(&layout, HINGE, low)),
                0.0,
            )
            .along(ball, arm, arm.dot(&arm), 0.0);
        let twist = LINKS.iter().fold(start, |twist, [inner, outer]| {
            let at = pose.at(outer);
            twist.along(at, at - pose.at(inner), 0.0, 0.0)
        });
        twist.moves(
            &pose,
            &[
                "lower_ball",
                "integral_upper",
                "camber_ball",
                "toe_ball",
                "axle",
            ],
        );
    }
}

/// The camber link is shorter than the lower arm.
#[test]
fn camber_decreases_over_bump() {
    let layout = Layout::read("integral_link");
    let wheels = TRAVEL.map(|bump| layout.moved(&[("bump", bump)]).wheel);
    assert!(wheels.iter().is_sorted_by(|a, b| a.camber > b.camber));
    assert!(wheels.iter().all(|wheel| wheel.toe.abs() < 0.02));
}

#[test]
fn the_integral_link_keeps_the_upright_from_pitching() {
    let layout = Layout::read("integral_link");
    for bump in TRAVEL {
        let pose = layout.moved(&[("bump", bump)]);
        let [ball, upper] = ["toe_ball", "integral_upper"].map(|point| pose.at(point));
        let [was, upper_was] = ["toe_ball", "integral_upper"].map(|point| layout.at(point));
        let pitch = (upper.z - ball.z) - (upper_was.z - was.z);
        assert!(
            pitch.abs() < 0.015 * (upper_was - was).norm(),
            "{pitch} m at {bump} m"
        );
    }
}
