//! The damper constrains nothing: all other parts move as in the layout without damper, and the damper's lower end moves with
//! the lower wishbone.

use super::layout::{CLOSE, Layout, TRAVEL};

#[test]
fn the_coilover_wishbone_moves_like_the_layout_without_damper() {
    let [with, without] = ["double_wishbone_coilover", "double_wishbone"].map(Layout::read);
    let design = with.moved(&[]);
    for bump in TRAVEL {
        for steer in [-0.03, 0.0, 0.03] {
            let [ours, other] =
                [&with, &without].map(|layout| layout.moved(&[("bump", bump), ("steer", steer)]));
            for point in [
                "lower_ball",
                "upper_ball",
                "tie_ball",
                "wheel_centre",
                "axle",
            ] {
                let off = (ours.at(point) - other.at(point)).norm();
                assert!(off < CLOSE, "{point} is {off:e} m off at {bump}, {steer}");
            }
            for point in ["lower_front", "lower_rear", "lower_ball"] {
                let [now, before] =
                    [&ours, &design].map(|pose| (pose.at("damper_lower") - pose.at(point)).norm());
                assert!(
                    (now - before).abs() < CLOSE,
                    "from {point}: {now} for {before}"
                );
            }
        }
    }
}

#[test]
fn bump_compresses_the_damper() {
    let layout = Layout::read("double_wishbone_coilover");
    let lengths = TRAVEL.map(|bump| layout.moved(&[("bump", bump)]).measure("damper"));
    assert!(lengths.is_sorted_by(|a, b| a > b), "{lengths:?}");
}
