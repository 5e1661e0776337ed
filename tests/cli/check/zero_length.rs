//! Measures of no length.

use super::super::program::{CORNER, text};
use super::{check, line};

/// The chassis end of the damper has the coordinates of its other end.
#[test]
fn a_measure_between_points_in_one_place_is_noted() {
    let doubt =
        "measure `damper` is zero at the design position, as its ends are in the same place";
    let both = "points = { damper_inner = [0.0, 0.34, 0.60] }\n[drives]";
    let output = check(&CORNER.replace("[drives]", both), &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let note = line(&output, "note");
    assert!(note.contains(doubt), "{note}");
    let output = check(CORNER, &[]);
    assert!(!text(&output.stdout).contains("is zero at"), "{output:?}");
}
