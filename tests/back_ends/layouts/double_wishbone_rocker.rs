//! The anti-roll bar of the other layout constrains nothing: all other parts move as in the layout with the bar.

use super::layout::{CLOSE, Layout, TRAVEL};

#[test]
fn the_rocker_layout_moves_like_the_layout_with_anti_roll_bar() {
    let [without, with] = ["double_wishbone_rocker", "double_wishbone_pushrod"].map(Layout::read);
    let points = ["wheel_centre", "axle", "pushrod_upper", "damper_outer"];
    for bump in TRAVEL {
        for steer in [-0.03, 0.0, 0.03] {
            let [ours, other] =
                [&without, &with].map(|layout| layout.moved(&[("bump", bump), ("steer", steer)]));
            for point in points {
                let off = (ours.at(point) - other.at(point)).norm();
                assert!(off < CLOSE, "{point} is {off:e} m off at {bump}, {steer}");
            }
            let off = (ours.measure("damper") - other.measure("damper")).abs();
            assert!(off < CLOSE, "the damper is {off:e} m off");
        }
    }
}

/// In bump the pushrod turns the rocker so that the damper is compressed.
#[test]
fn bump_compresses_the_damper() {
    let layout = Layout::read("double_wishbone_rocker");
    let lengths = TRAVEL.map(|bump| layout.moved(&[("bump", bump)]).measure("damper"));
    assert!(lengths.is_sorted_by(|a, b| a > b), "{lengths:?}");
}
