//! Measures that lead beyond the reach of the mechanism at the first instant.

use super::super::program::{folder, run, text};
use super::{edited, write};

#[test]
fn a_first_height_beyond_its_extreme_value_is_out_of_reach() {
    let folder = folder();
    let high = edited("five_link_height.toml", &[("[358.0, -50.0]", "[360.0]")]);
    write(folder.path(), "a.toml", &high);
    let output = run(folder.path(), &["motion", "a.toml"]);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let message = text(&output.stderr);
    assert_eq!(message.lines().count(), 1);
    for expected in [
        "t = 0 s with height = 360 mm",
        "measure `height` has an extreme value of 358.9",
    ] {
        assert!(
            message.contains(expected),
            "{expected} is not in: {message}"
        );
    }
}

/// As their help says, and as where drives lead.
#[test]
fn with_a_first_height_out_of_reach_the_design_is_drawn_and_has_ranges() {
    let folder = folder();
    let high = edited("five_link_height.toml", &[("[358.0, -50.0]", "[360.0]")]);
    write(folder.path(), "a.toml", &high);
    for arguments in [
        ["range", "a.toml"].as_slice(),
        &["draw", "a.toml", "--out", "-"],
    ] {
        let output = run(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let notes = text(&output.stderr);
        let first =
            "note: a.toml: the first instant, t = 0 s with height = 360 mm, is out of reach";
        let note = notes.lines().find(|note| note.starts_with(first));
        let note = note.unwrap_or_else(|| panic!("{notes}"));
        assert!(
            note.ends_with("; it stays at the design position"),
            "{note}"
        );
    }
    let range = run(folder.path(), &["range", "a.toml"]);
    let report = text(&range.stdout);
    for expected in [
        "from 40.10705 deg (0.7 rad) at the design position",
        "  motion      the file's motion begins out of reach\n",
    ] {
        assert!(report.contains(expected), "{report}");
    }
}
