//! A line across the vehicle: camber and toe stay, and the wheel centre is on a circle.

use super::layout::{CLOSE, Layout, TRAVEL};

#[test]
fn the_wheel_centre_moves_on_a_circle_with_constant_camber() {
    let layout = Layout::read("trailing_arm");
    let (pivot, start) = (layout.at("pivot_outer"), layout.at("wheel_centre"));
    let radius = (start - pivot).xz().norm();
    for bump in TRAVEL {
        let pose = layout.moved(&[("bump", bump)]);
        let rise = start.z + bump - pivot.z;
        let centre = pose.at("wheel_centre");
        assert!((centre.x - (pivot.x - (radius * radius - rise * rise).sqrt())).abs() < CLOSE);
        assert!((centre.y - start.y).abs() < CLOSE);
        assert!(pose.wheel.camber.abs() < CLOSE && pose.wheel.toe.abs() < CLOSE);
    }
}
