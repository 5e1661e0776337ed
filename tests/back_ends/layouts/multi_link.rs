//! The knuckle moves as its five links let it.

use super::layout::{Layout, TRAVEL};
use super::twist::Twist;

const LINKS: [&str; 5] = [
    "lower_front",
    "upper_front",
    "upper_rear",
    "lower_rear",
    "track_rod",
];

#[test]
fn the_knuckle_velocity_satisfies_its_five_links() {
    let layout = Layout::read("multi_link");
    for bump in TRAVEL {
        let pose = layout.moved(&[("bump", bump)]);
        let outer = LINKS.map(|link| format!("{link}_outer"));
        let start = Twist::default().without_arm();
        let twist = LINKS
            .iter()
            .zip(&outer)
            .fold(start, |twist, (link, outer)| {
                let at = pose.at(outer);
                twist.along(at, at - pose.at(&format!("{link}_inner")), 0.0, 0.0)
            });
        let points: Vec<&str> = outer.iter().map(String::as_str).chain(["axle"]).collect();
        twist.moves(&pose, &points);
    }
}
