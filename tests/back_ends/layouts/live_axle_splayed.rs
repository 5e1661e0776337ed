//! Mirrored motions mirror; the axle rolls about where the upper links' lines meet.

use super::layout::{CLOSE, Layout, TRAVEL, rolls_about};

#[test]
fn heave_keeps_the_axle_centred_and_the_wheels_upright() {
    let layout = Layout::read("live_axle_splayed");
    for bump in TRAVEL {
        let pose = layout.moved(&[("bump_left", bump), ("bump_right", bump)]);
        assert!(pose.off_mirrored(&pose) < CLOSE);
        assert!(pose.wheel.camber.abs() < CLOSE && pose.wheel.toe.abs() < CLOSE);
    }
}

#[test]
fn roll_to_the_left_mirrors_roll_to_the_right() {
    let layout = Layout::read("live_axle_splayed");
    for bump in TRAVEL {
        let [left, right] =
            [bump, -bump].map(|by| layout.moved(&[("bump_left", by), ("bump_right", -by)]));
        assert!(left.off_mirrored(&right) < CLOSE);
    }
}

#[test]
fn the_axle_rolls_about_the_intersection_of_the_upper_links() {
    let layout = Layout::read("live_axle_splayed");
    let [front, rear] = ["upper_left_front", "upper_left_rear"].map(|point| layout.at(point));
    rolls_about(
        &layout,
        front + (rear - front) * (front.y / (front.y - rear.y)),
    );
}
