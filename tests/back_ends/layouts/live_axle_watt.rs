//! The crank's centre moves up and down nearly straight, and the axle rolls about it.

use super::layout::{Layout, TRAVEL, rolls_about};

#[test]
fn in_heave_the_crank_centre_moves_on_nearly_a_straight_line() {
    let layout = Layout::read("live_axle_watt");
    for bump in TRAVEL {
        let pose = layout.moved(&[("bump_left", bump), ("bump_right", bump)]);
        let aside = pose.at("crank_rear").y;
        // Watt's curve leaves its tangent with the fifth power of the travel; a Panhard rod with the second.
        assert!(aside.abs() < 3e-5, "{aside} m at {bump} m");
    }
}

#[test]
fn the_axle_rolls_about_the_crank_centre() {
    let layout = Layout::read("live_axle_watt");
    rolls_about(&layout, layout.at("crank_rear"));
}

#[test]
fn opposite_bumps_give_the_roll_travel() {
    let layout = Layout::read("live_axle_watt");
    for bump in TRAVEL {
        let pose = layout.moved(&[("bump_left", bump), ("bump_right", -bump)]);
        assert!((pose.measure("roll_travel") - 2.0 * bump).abs() < 1e-14);
    }
}
