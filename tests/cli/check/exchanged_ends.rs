//! Links whose ends have each other's coordinates.

use super::super::program::{CORNER, text};
use super::check;

#[test]
fn a_tie_rod_whose_ends_have_each_others_coordinates_is_noted() {
    let doubt = "`rack`, the inner end of `tie_rod`, is further from the middle of the vehicle than its outer end `tie_ball`";
    let both = "points = { rack = [0.12, 0.68, 0.21], tie_ball = [0.11, 0.34, 0.20] }\n[drives]";
    let corner = CORNER.replace("[drives]", both);
    let output = check(&corner.replace("steer = 0.34", "steer = 0.68"), &[]);
    let report = text(&output.stdout);
    assert!(report.contains(doubt), "{output:?}");
    for listing in [
        CORNER,
        include_str!("../../../examples/live_axle_splayed.toml"),
    ] {
        let output = check(listing, &[]);
        let report = text(&output.stdout);
        assert!(!report.contains("inner end"), "{report}");
    }
}
