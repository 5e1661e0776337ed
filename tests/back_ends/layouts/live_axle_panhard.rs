//! The rod guides the axle on a circle, and the axle rolls about the point at which the rod passes its plane of symmetry.

use super::layout::{Layout, TRAVEL, rolls_about};

#[test]
fn in_heave_the_axle_moves_sideways_on_the_circle_of_the_rod() {
    let layout = Layout::read("live_axle_panhard");
    let rod = layout.at("panhard_axle") - layout.at("panhard_chassis");
    let start = layout.at("left_wheel_centre").y;
    let mut furthest: f64 = 0.0;
    for bump in TRAVEL {
        let pose = layout.moved(&[("bump_left", bump), ("bump_right", bump)]);
        let rise = rod.z + bump;
        let span = (rod.norm_squared() - rise * rise).sqrt();
        let shift = pose.at("left_wheel_centre").y - start;
        // Fore and aft the rod leans by a few millimetres, which shortens its span by hundredths.
        assert!(
            (shift - (span - rod.y)).abs() < 1e-4,
            "{shift} m at {bump} m"
        );
        furthest = furthest.max(shift.abs());
    }
    assert!(furthest > 3e-3);
}

#[test]
fn the_axle_rolls_about_the_rod_at_the_plane_of_symmetry() {
    let layout = Layout::read("live_axle_panhard");
    let [axle, chassis] = ["panhard_axle", "panhard_chassis"].map(|point| layout.at(point));
    rolls_about(
        &layout,
        chassis + (axle - chassis) * (chassis.y / (chassis.y - axle.y)),
    );
}

#[test]
fn opposite_bumps_roll_the_axle_and_lean_its_wheels() {
    let layout = Layout::read("live_axle_panhard");
    for bump in TRAVEL {
        let pose = layout.moved(&[("bump_left", bump), ("bump_right", -bump)]);
        assert!((pose.measure("roll_travel") - 2.0 * bump).abs() < 1e-14);
        let lean = (2.0 * bump / 1.48).asin();
        assert!(
            (pose.wheel.camber + lean).abs() < 1e-3,
            "a wheel leans as the axle does"
        );
    }
}
