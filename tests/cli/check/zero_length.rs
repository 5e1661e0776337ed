//! Measures of no length.

use super::super::program::{CORNER, text};
use super::{check, line};

/// The chassis end of the damper has the coordinates of its other end.
#[test]
fn a_measure_between_points_in_one_place_is_noted() {
    let doubt = "`damper_inner` and `damper_outer` are in the same place at the design position";
    let both = "points = { damper_inner = [0.0, 0.34, 0.60] }\n[drives]";
    let output = check(&CORNER.replace("[drives]", both), &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let note = line(&output, "note");
    assert!(note.contains(doubt), "{note}");
    let output = check(CORNER, &[]);
    assert!(
        !text(&output.stdout).contains("in the same place"),
        "{output:?}"
    );
}

/// The difference of two heights is zero at the design, and means something else.
#[test]
fn a_measured_sum_that_is_zero_is_not_noted() {
    let output = check(include_str!("../../../examples/live_axle_watt.toml"), &[]);
    assert_eq!(line(&output, "notes"), "notes         none");
}
