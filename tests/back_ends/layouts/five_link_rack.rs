//! The knuckle moves as four links and a tie rod let it, and steers about an axis that no ball joint lies on.

use super::layout::{Layout, TRAVEL};
use super::twist::Twist;

const LINKS: [[&str; 2]; 5] = [
    ["lateral_inner", "lateral_ball"],
    ["diagonal_inner", "diagonal_ball"],
    ["upper_front_inner", "upper_front_ball"],
    ["upper_rear_inner", "upper_rear_ball"],
    ["rack", "tie_ball"],
];

#[test]
fn the_knuckle_velocity_satisfies_its_links_and_tie_rod() {
    let layout = Layout::read("five_link_rack");
    for bump in TRAVEL {
        for steer in [-0.04, 0.0, 0.04] {
            let pose = layout.moved(&[("bump", bump), ("steer", steer)]);
            let start = Twist::default().without_arm();
            let twist = LINKS.iter().fold(start, |twist, [inner, outer]| {
                let at = pose.at(outer);
                twist.along(at, at - pose.at(inner), 0.0, 0.0)
            });
            let balls = LINKS.map(|[_, outer]| outer);
            twist.moves(&pose, &[&balls[..], &["axle"]].concat());
        }
    }
}

#[test]
fn the_rack_ahead_of_the_axle_gives_toe_and_camber_their_signs() {
    let layout = Layout::read("five_link_rack");
    let at = |bump, steer| layout.moved(&[("bump", bump), ("steer", steer)]).wheel;
    assert!(at(0.0, 0.04).toe < -0.2 && at(0.0, -0.04).toe > 0.2);
    assert!(at(0.06, 0.0).camber < 0.0 && at(-0.06, 0.0).camber > 0.0);
}
