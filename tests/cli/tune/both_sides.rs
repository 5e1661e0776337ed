//! Moves of an axle's left side that are mirrored to its right side.

use std::path::Path;

use super::super::program::{folder, rows, run, text};
use super::{file, met, target, tuned};

/// The toe of both wheels in the file that was written, in degrees.
fn assert_toes(folder: &Path, expected: f64) {
    let sweep = [
        "sweep",
        "a_tuned.toml",
        "--drive",
        "steer=0.0",
        "--csv",
        "-",
    ];
    let output = run(folder, &sweep);
    let row = &rows(&output.stdout)[0];
    for toe in ["left_toe_deg", "right_toe_deg"] {
        assert!((row[toe] - expected).abs() < 1e-5, "{row:?}");
    }
    let difference = row["left_toe_deg"] - row["right_toe_deg"];
    assert!(difference.abs() < 1e-6, "{row:?}");
}

/// The written file is symmetric.
#[test]
fn moves_of_mirrored_points_keep_an_axle_symmetric() {
    let folder = folder();
    let tune = "\
[tune.moves.axle]
points = [\"left_axle\"]
mirrored = [\"right_axle\"]
along = [1.0, 1.0, 0.0]
by = [-0.02, 0.02]
";
    let tune = tune.to_owned() + &target("left_toe", 0.1, 1e-5);
    let drives = "bump_left = 0.3\nbump_right = 0.3\nsteer = 0.0";
    met(folder.path(), &file("steered_axle", drives, &tune));
    assert_toes(folder.path(), 0.1);
}

/// Turnbuckles of both sides change by the same length: the written file is symmetric.
#[test]
fn a_mirrored_length_is_moved_equally() {
    let folder = folder();
    let turnbuckles = |mirrored: &str| {
        format!(
            "[tune.moves.turnbuckle]\nlength = \"left_tie_rod\"\nmirrored = [\"{mirrored}\"]\nby = [-0.005, 0.005]\n"
        ) + &target("left_toe", 0.1, 1e-5)
    };
    let drives = "bump_left = 0.3\nbump_right = 0.3\nsteer = 0.34";
    let axle = |mirrored| file("steered_axle", drives, &turnbuckles(mirrored));
    met(folder.path(), &axle("right_tie_rod"));
    assert_toes(folder.path(), 0.1);
    let output = tuned(folder.path(), &axle("left_tie_rod"));
    let messages = text(&output.stderr);
    assert!(
        messages.contains("`left_tie_rod` is moved twice by one move"),
        "{messages}"
    );
}

/// The mirrored point must be on the other side.
#[test]
fn a_mirrored_point_of_the_same_side_is_refused() {
    let folder = folder();
    let tune = "[tune.moves.ball]\npoints = [\"left_tie_ball\"]\nmirrored = [\"left_lower_ball\"]\nalong = \"z\"\nby = [-0.02, 0.02]\n";
    let tune = tune.to_owned() + &target("left_toe", 0.1, 1e-5);
    let drives = "bump_left = 0.3\nbump_right = 0.3\nsteer = 0.34";
    let output = tuned(folder.path(), &file("steered_axle", drives, &tune));
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let messages = text(&output.stderr);
    assert!(
        messages.starts_with(
            "a.toml:12:13: `left_lower_ball` is on the side of the vehicle that `left_tie_ball` is on; `mirrored` names the points of the \
             other side"
        ),
        "{messages}"
    );
}
