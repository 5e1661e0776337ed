//! In heave one body that turns about the line of the bushes; in roll each arm turns about the line from its bush to
//! the middle of the beam.

use super::layout::{CLOSE, Layout, TRAVEL};

#[test]
fn in_heave_both_arms_turn_about_the_line_of_the_bushes() {
    let layout = Layout::read("twist_beam");
    let (bush, start) = (layout.at("left_bush"), layout.at("left_wheel_centre"));
    let radius = (start - bush).xz().norm();
    for bump in TRAVEL {
        let pose = layout.moved(&[("bump_left", bump), ("bump_right", bump)]);
        assert!(pose.off_mirrored(&pose) < CLOSE);
        let centre = pose.at("left_wheel_centre");
        assert!(((centre - bush).xz().norm() - radius).abs() < CLOSE);
        assert!((centre.y - start.y).abs() < CLOSE);
        assert!(pose.wheel.camber.abs() < CLOSE && pose.wheel.toe.abs() < CLOSE);
    }
}

#[test]
fn in_roll_each_arm_turns_about_its_bush_and_the_beam_middle() {
    let layout = Layout::read("twist_beam");
    let mut middle = layout.at("left_outer");
    middle.y = 0.0;
    let axis = middle - layout.at("left_bush");
    let pose = layout.moved(&[]);
    let per = |point| pose.per("bump_left", point) - pose.per("bump_right", point);
    let spin = per("left_wheel_centre") - per("left_axle");
    assert!((-spin.x / spin.z - axis.z / axis.x).abs() < 1e-9);
    assert!(
        per("left_outer").dot(&axis).abs() < 1e-9,
        "square to the axis"
    );
}

#[test]
fn roll_to_the_left_mirrors_roll_to_the_right() {
    let layout = Layout::read("twist_beam");
    for bump in TRAVEL {
        let [left, right] =
            [bump, -bump].map(|by| layout.moved(&[("bump_left", by), ("bump_right", -by)]));
        assert!(left.off_mirrored(&right) < CLOSE);
        let lean = left.wheel.camber * bump;
        assert!(lean <= 0.0, "the wheel in bump leans inboard");
    }
}
