//! The knuckle moves as top mount, two lower links and tie rod let it.

use super::layout::{Layout, TRAVEL};
use super::twist::Twist;

const LINKS: [[&str; 2]; 3] = [
    ["lateral_inner", "lateral_ball"],
    ["tension_inner", "tension_ball"],
    ["rack", "tie_ball"],
];

#[test]
fn the_knuckle_velocity_satisfies_top_mount_two_links_and_tie_rod() {
    let layout = Layout::read("macpherson_two_links");
    for bump in TRAVEL {
        for steer in [-0.06, 0.0, 0.06] {
            let pose = layout.moved(&[("bump", bump), ("steer", steer)]);
            let [top, low, high] = ["top", "strut_low", "strut_high"].map(|point| pose.at(point));
            let start = Twist::default().only_along(top, high - low).without_arm();
            let twist = LINKS.iter().fold(start, |twist, [inner, outer]| {
                let at = pose.at(outer);
                twist.along(at, at - pose.at(inner), 0.0, 0.0)
            });
            let balls = LINKS.map(|[_, outer]| outer);
            twist.moves(
                &pose,
                &[&balls[..], &["strut_low", "strut_high", "axle"]].concat(),
            );
            assert!((pose.measure("damper") - (top - low).norm()).abs() < 1e-14);
        }
    }
}

#[test]
fn the_rack_ahead_of_the_axle_gives_toe_and_camber_their_signs() {
    let layout = Layout::read("macpherson_two_links");
    let at = |bump, steer| layout.moved(&[("bump", bump), ("steer", steer)]).wheel;
    let [left, right] = [0.06, -0.06].map(|rack| at(0.0, rack).toe);
    assert!(
        left < -0.4 && right > 0.4 && left.abs() > right,
        "the inner wheel turns more"
    );
    assert!(at(0.06, 0.0).camber < 0.0 && at(-0.06, 0.0).camber > 0.0);
    assert!(at(0.06, 0.0).toe.abs() < 0.003 && at(-0.06, 0.0).toe.abs() < 0.003);
}
