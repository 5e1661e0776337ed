//! The damper constrains nothing: all other parts move as in the layout without damper, and the damper's lower end moves with
//! the knuckle.

use super::layout::{CLOSE, Layout, TRAVEL};

#[test]
fn the_coilover_knuckle_moves_like_the_layout_without_damper() {
    let [with, without] = ["multi_link_coilover", "multi_link"].map(Layout::read);
    let design = with.moved(&[]);
    for bump in TRAVEL {
        let [ours, other] = [&with, &without].map(|layout| layout.moved(&[("bump", bump)]));
        for point in [
            "lower_front_outer",
            "track_rod_outer",
            "wheel_centre",
            "axle",
        ] {
            let off = (ours.at(point) - other.at(point)).norm();
            assert!(off < CLOSE, "{point} is {off:e} m off at {bump}");
        }
        for point in ["lower_front_outer", "upper_rear_outer", "track_rod_outer"] {
            let [now, before] =
                [&ours, &design].map(|pose| (pose.at("damper_lower") - pose.at(point)).norm());
            assert!(
                (now - before).abs() < CLOSE,
                "from {point}: {now} for {before}"
            );
        }
    }
    let lengths = TRAVEL.map(|bump| with.moved(&[("bump", bump)]).measure("damper"));
    assert!(lengths.is_sorted_by(|a, b| a > b), "{lengths:?}");
}
