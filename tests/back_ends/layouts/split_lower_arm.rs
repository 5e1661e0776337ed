//! The upright moves as upper wishbone, two lower links and tie rod let it, and steers about a virtual joint.

use nalgebra::Vector3;

use super::layout::{Layout, Pose, TRAVEL};
use super::twist::{Twist, about};

const HINGE: [&str; 2] = ["upper_front", "upper_rear"];
const LINKS: [[&str; 2]; 3] = [
    ["lateral_inner", "lateral_ball"],
    ["diagonal_inner", "diagonal_ball"],
    ["rack", "tie_ball"],
];

#[test]
fn the_upright_velocity_satisfies_its_arms_and_tie_rod() {
    let layout = Layout::read("split_lower_arm");
    for bump in TRAVEL {
        for steer in [-0.04, 0.0, 0.04] {
            let pose = layout.moved(&[("bump", bump), ("steer", steer)]);
            let ball = pose.at("upper_ball");
            let wishbone = about(&layout, HINGE, ball);
            let start = Twist::default().only_along(ball, wishbone).without_arm();
            let twist = LINKS.iter().fold(start, |twist, [inner, outer]| {
                let at = pose.at(outer);
                twist.along(at, at - pose.at(inner), 0.0, 0.0)
            });
            let points = [
                "upper_ball",
                "lateral_ball",
                "diagonal_ball",
                "tie_ball",
                "axle",
            ];
            twist.moves(&pose, &points);
        }
    }
}

/// Returns the point at which the line of a link passes a transverse plane, at x.
fn passes(pose: &Pose, [inner, outer]: [&str; 2], x: f64) -> Vector3<f64> {
    let [inner, outer] = [inner, outer].map(|point| pose.at(point));
    inner + (outer - inner) * ((x - inner.x) / (outer.x - inner.x))
}

/// In plan view the lower links' lines meet outboard of both ball joints, which is impossible with a wishbone.
#[test]
fn the_virtual_lower_joint_is_outboard_of_both_ball_joints() {
    let layout = Layout::read("split_lower_arm");
    let pose = layout.moved(&[]);
    let [lateral, diagonal, _] = LINKS;
    let lead = |x: f64| passes(&pose, diagonal, x).y - passes(&pose, lateral, x).y;
    let (mut low, mut high) = (-0.025, 0.05);
    assert!(lead(low) * lead(high) < 0.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if lead(middle) * lead(high) < 0.0 {
            low = middle
        } else {
            high = middle
        }
    }
    let joint = passes(&pose, diagonal, low);
    assert!(joint.y > pose.at("lateral_ball").y && joint.y > pose.at("diagonal_ball").y);
}

#[test]
fn the_rack_behind_the_axle_gives_toe_and_camber_their_signs() {
    let layout = Layout::read("split_lower_arm");
    let at = |bump, steer| layout.moved(&[("bump", bump), ("steer", steer)]).wheel;
    assert!(at(0.0, 0.04).toe > 0.2 && at(0.0, -0.04).toe < -0.2);
    assert!(at(0.06, 0.0).camber < 0.0 && at(-0.06, 0.0).camber > 0.0);
}
