//! Designs whose drives cannot be followed.

use super::super::program::text;
use super::{check, line};

/// A mistyped height of the wheel centre, in m: at some of these rounding leaves more than the tolerance, and no drive can be followed.
#[test]
fn a_design_whose_drives_cannot_be_followed_has_a_report_with_notes() {
    let of = |height: f64| {
        let file = format!(
            "linkage = \"double_wishbone\"\nunit = \"m\"\ntime = {{ instants = [0.0] }}\n\
             drives = {{ bump = {height:?}, steer = 0.34 }}\npoints = {{ wheel_centre = [0.0, 0.75, {height:?}] }}\n"
        );
        let output = check(&file, &[]);
        assert!(line(&output, "residual").ends_with("the design assembles"));
        let note = line(&output, "note");
        assert!(note.contains("`wheel_centre` lies "), "{note}");
        output
    };
    let outputs = [250.0, 300.0, 1000.0, 3000.0, 3500.0].map(of);
    let unknown = "NOT KNOWN: the curve of the drive `";
    let mut left = outputs
        .iter()
        .filter(|output| text(&output.stdout).contains(unknown));
    let output = left.next().expect("one whose drives cannot be followed");
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    assert!(line(output, "reach").contains(unknown));
    let message = text(&output.stderr);
    assert_eq!(
        message,
        "a.toml: the reach of the drives is not known; the report says why\n"
    );
}
