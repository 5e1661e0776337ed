//! An axle, of which both sides move.

use super::super::program::{folder, text};
use super::{compare_with_sweep, varied, vary};

const AXLE: &str = "\
linkage = \"steered_axle\"
unit = \"m\"
angle = \"deg\"
vehicle = { wheel_radius = 0.3, wheelbase = 2.6 }
time = { instants = [0.0] }
[drives]
bump_left = 0.3
bump_right = 0.3
steer = 0.34
";

fn axle(points: &str) -> String {
    format!("{AXLE}[points]\n{points}")
}

#[test]
fn both_sides_move_as_in_the_file_written_by_hand() {
    for (words, points) in [
        (
            "left_tie_ball.z,right_tie_ball.z=0.004",
            "left_tie_ball = [0.12, 0.68, 0.214]\nright_tie_ball = [0.12, -0.68, 0.214]\n",
        ),
        (
            "left_tie_ball.y,-right_tie_ball.y=0.004",
            "left_tie_ball = [0.12, 0.684, 0.21]\nright_tie_ball = [0.12, -0.684, 0.21]\n",
        ),
    ] {
        let (value, numbers) = varied(&axle(""), words).remove(1);
        assert_eq!(value, 0.004);
        let compared = compare_with_sweep(&numbers, &axle(points), "bump_left");
        assert!(compared > 200, "{compared}");
    }
}

/// The rack slides in a housing, which moves with it: one end or both are the same, and both by as much as is asked for.
#[test]
fn the_ends_of_a_rack_move_with_its_line_once() {
    let points = "housing_left = [0.11, 0.2, 0.206]\nhousing_right = [0.11, -0.2, 0.206]\n\
                  rack_left = [0.11, 0.34, 0.206]\nrack_right = [0.11, -0.34, 0.206]\n";
    for words in ["rack_left.z=0.006", "rack_left.z,rack_right.z=0.006"] {
        let (_, numbers) = varied(&axle(""), words).remove(1);
        compare_with_sweep(&numbers, &axle(points), "bump_left");
    }
    let folder = folder();
    let output = vary(
        folder.path(),
        &axle(""),
        &["rack_left.z,-rack_right.z=0.006"],
    );
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let message = text(&output.stderr);
    assert!(message.contains("moves `housing_"), "{message}");
    assert!(message.contains("in two ways"), "{message}");
}

/// A rack's end that moves along its line goes with the line that the other end moves.
#[test]
fn an_end_of_a_rack_moves_along_the_line_that_the_other_end_moves() {
    let points = "housing_left = [0.11, 0.2, 0.206]\nhousing_right = [0.11, -0.2, 0.206]\n\
                  rack_left = [0.11, 0.346, 0.206]\nrack_right = [0.11, -0.34, 0.206]\n";
    let by_hand = axle(points).replace("steer = 0.34", "steer = 0.346");
    let (_, numbers) = varied(&axle(""), "rack_left.y,rack_right.z=0.006").remove(1);
    compare_with_sweep(&numbers, &by_hand, "bump_left");
}

#[test]
fn one_side_alone_is_noted_with_the_names_that_move_both() {
    let folder = folder();
    for (words, expected) in [
        (
            "left_tie_ball.z=0.004",
            "left_tie_ball.z,right_tie_ball.z keeps both sides alike",
        ),
        (
            "left_tie_ball.y=0.004",
            "left_tie_ball.y,-right_tie_ball.y keeps both sides alike",
        ),
        (
            "right_tie_rod=0.001",
            "right_tie_rod,left_tie_rod keeps both sides alike",
        ),
    ] {
        let output = vary(folder.path(), &axle(""), &[words, "--of", "left_toe"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let message = text(&output.stderr);
        assert!(message.starts_with("note: a.toml: "), "{message}");
        assert!(message.contains(expected), "{message}");
    }
    for words in ["rack_left.z=0.004", "left_tie_rod,right_tie_rod=0.001"] {
        let output = vary(folder.path(), &axle(""), &[words, "--of", "left_toe"]);
        assert_eq!(text(&output.stderr), "", "{words}");
    }
}
