//! A rotation about a fixed line, in closed form.

use nalgebra::{Rotation3, Unit, Vector3};

use super::layout::{CLOSE, Layout, TRAVEL};

/// The angle about a line at which an arm's tip is higher by `rise`: `A cos + B sin = A + rise`.
fn angle(axis: &Vector3<f64>, arm: &Vector3<f64>, rise: f64) -> f64 {
    let a = (arm - axis * axis.dot(arm)).z;
    let b = axis.cross(arm).z;
    let (size, phase) = (a.hypot(b), b.atan2(a));
    let away = ((a + rise) / size).acos();
    let turns = [phase - away, phase + away];
    turns
        .into_iter()
        .min_by(|a, b| a.abs().total_cmp(&b.abs()))
        .expect("two")
}

#[test]
fn all_points_turn_about_the_pivot_line() {
    let layout = Layout::read("semi_trailing_arm");
    let origin = layout.at("pivot_inner");
    let axis = Unit::new_normalize(layout.at("pivot_outer") - origin);
    let arm = layout.at("wheel_centre") - origin;
    for bump in TRAVEL {
        let pose = layout.moved(&[("bump", bump)]);
        let turn = Rotation3::from_axis_angle(&axis, angle(&axis, &arm, bump));
        for point in [
            "wheel_centre",
            "shaft_outer",
            "spring_lower",
            "damper_lower",
        ] {
            let expected = origin + turn * (layout.at(point) - origin);
            assert!((pose.at(point) - expected).norm() < CLOSE, "{point}");
        }
        let spin = turn * Vector3::y();
        assert!((pose.wheel.camber - (-spin.z).atan2(spin.y)).abs() < CLOSE);
        assert!((pose.wheel.toe - spin.x.atan2(spin.y)).abs() < CLOSE);
    }
}

#[test]
fn camber_decreases_over_bump() {
    let layout = Layout::read("semi_trailing_arm");
    let camber = TRAVEL.map(|bump| layout.moved(&[("bump", bump)]).wheel.camber);
    assert!(camber.is_sorted_by(|a, b| a > b), "{camber:?}");
    assert!((0.02..0.07).contains(&camber[0]));
}
