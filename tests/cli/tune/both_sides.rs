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

/// The drives of `steered_axle` at its design position.
const AXLE: &str = "bump_left = 0.3\nbump_right = 0.3\nsteer = 0.34";

/// In heave both wheels of a symmetric axle are alike, in roll one is as the other with the opposite travel: a move of both
/// sides meets a target that a known design has.
#[test]
fn targets_are_stated_over_heave_and_roll_as_for_sweep() {
    let lower = |z: f64| {
        let at = |side: &str, y: f64| format!("{side}_tie_ball = [0.12, {y:?}, {z:?}]\n");
        format!("[points]\n{}{}", at("left", 0.68), at("right", -0.68))
    };
    for (over, sweep) in [
        ("\"bump_left,bump_right\"", "bump_left,bump_right"),
        ("\"bump_left, -bump_right\"", "bump_left,-bump_right"),
    ] {
        let folder = folder();
        let points = lower(0.22);
        std::fs::write(
            folder.path().join("known.toml"),
            file("steered_axle", AXLE, &points),
        )
        .expect("written");
        let known = |name: &str| {
            let drive = format!("{sweep}=-0.04:0.04:5");
            let output = run(
                folder.path(),
                &["sweep", name, "--drive", &drive, "--csv", "-"],
            );
            assert_eq!(output.status.code(), Some(0), "{output:?}");
            let rows = rows(&output.stdout);
            rows.iter()
                .map(|row| row["left_toe_deg"])
                .collect::<Vec<f64>>()
        };
        let wanted = known("known.toml");
        let tune = format!(
            "[tune.moves.ball]\npoints = [\"left_tie_ball\"]\nmirrored = [\"right_tie_ball\"]\nalong = \"z\"\nby = [-0.02, 0.02]\n\
             [tune.targets.toe]\nof = \"left_toe\"\nover = {{ {over} = [-0.04, 0.04] }}\nvalue = {wanted:?}\nwithin = 1e-4\n"
        );
        met(folder.path(), &file("steered_axle", AXLE, &tune));
        for (found, wanted) in known("a_tuned.toml").iter().zip(&wanted) {
            assert!((found - wanted).abs() <= 1e-4, "{over}: {found} {wanted}");
        }
    }
}

#[test]
fn a_drive_that_is_named_twice_by_a_target_is_refused() {
    let folder = folder();
    for (over, place, expected) in [
        (
            "bump_left = [-0.04, 0.04], \"-bump_left\" = [-0.04, 0.04]",
            "16:37",
            "the drive `bump_left` is given twice",
        ),
        (
            "\"bump_left,heave\" = [-0.04, 0.04]",
            "16:10",
            "unknown drive `heave`; known are steer, bump_left, bump_right",
        ),
    ] {
        let tune = format!(
            "[tune.moves.ball]\npoints = [\"left_tie_ball\"]\nalong = \"z\"\nby = [-0.02, 0.02]\n\
             [tune.targets.toe]\nof = \"left_toe\"\nover = {{ {over} }}\nvalue = 0.0\nwithin = 1e-4\n"
        );
        let output = tuned(folder.path(), &file("steered_axle", AXLE, &tune));
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let message = text(&output.stderr);
        assert!(
            message.contains(&format!("a.toml:{place}: {expected}")),
            "{message}"
        );
    }
}

/// A length that changes on one side makes the axle asymmetric; with the line of the note it does not.
#[test]
fn a_move_of_one_side_is_noted_with_the_line_that_mirrors_it() {
    let folder = folder();
    let target = target("left_toe", 0.1, 1e-5);
    let note = "note: a.toml: [tune.moves.turnbuckle] moves only one side of the vehicle, `right_tie_rod` stays where the file has \
                it; to keep both sides alike, write mirrored = [\"right_tie_rod\"] there\n";
    let one =
        "[tune.moves.turnbuckle]\nlength = \"left_tie_rod\"\nby = [-0.005, 0.005]\n".to_owned();
    let other = one
        .replace("left_", "right_")
        .replace("moves.", "moves.right_");
    let mirrored = one.clone() + "mirrored = [\"right_tie_rod\"]\n";
    let both = one.clone() + &other;
    for (moves, is_noted) in [(one, true), (mirrored, false), (both, false)] {
        let output = met(
            folder.path(),
            &file("steered_axle", AXLE, &(moves.clone() + &target)),
        );
        assert_eq!(
            text(&output.stderr).contains(note),
            is_noted,
            "{moves}: {output:?}"
        );
        assert_eq!(text(&output.stderr).contains("only one side"), is_noted);
    }
}
