//! Quantities that only one of two files has, and quantities that are equal.

use super::super::program::{CORNER, text};
use super::axles::axles;
use super::{compare, rows};

#[test]
fn quantities_of_only_one_file_are_named_once() {
    let rocker = CORNER.replace("double_wishbone_pushrod", "double_wishbone_rocker");
    let axle = CORNER
        .replace("double_wishbone_pushrod", "steered_axle")
        .replace("bump = 0.3", "bump_left = 0.3\nbump_right = 0.3");
    let only_lines = |a: &str, b: &str| {
        let (_folder, output) = compare(a, b, &[]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let report = text(&output.stdout).lines();
        let only_lines = report.filter(|line| line.starts_with("only "));
        only_lines.map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(only_lines(CORNER, &rocker), ["only A has: bar_arm (deg)"]);
    assert_eq!(only_lines(&rocker, CORNER), ["only B has: bar_arm (deg)"]);
    assert_eq!(only_lines(CORNER, CORNER), [""; 0]);
    let [of_corner, of_axle] =
        <[String; 2]>::try_from(only_lines(CORNER, &axle)).expect("two lines");
    assert_eq!(of_corner, "only A has: damper (m), bar_arm (deg)");
    assert!(of_axle.starts_with("only B has: "), "{of_axle}");
    assert!(of_axle.contains("roll_travel (m)"), "{of_axle}");
    assert!(!of_axle.contains("camber angle"), "{of_axle}");
}

#[test]
fn a_missing_wheel_radius_is_named_as_the_reason() {
    let without = CORNER.replace("vehicle = { wheel_radius = 0.3 }\n", "");
    assert_ne!(without, CORNER);
    let notes = |a: &str, b: &str| {
        let (_folder, output) = compare(a, b, &[]);
        let report = text(&output.stdout).lines();
        let notes = report.filter(|line| line.contains("wheel_radius"));
        notes.map(str::to_owned).collect::<Vec<_>>()
    };
    for (a, b, named) in [(without.as_str(), CORNER, "A"), (CORNER, &without, "B")] {
        let expected = format!(
            "{named} states no wheel_radius: write it under [vehicle], so that contact point, scrub radius, mechanical trail and roll centre are compared"
        );
        assert_eq!(notes(a, b), [expected]);
    }
    assert_eq!(notes(&without, &without), [""; 0]);
    assert_eq!(notes(CORNER, CORNER), [""; 0]);
}

/// For four wheels against two, a line that names each quantity would be longer than the comparison.
#[test]
fn wheels_of_only_one_file_are_named_as_a_whole() {
    let front = [("front_left", 0.0, 1.0), ("front_right", 0.0, -1.0)];
    let rear = [("rear_left", -2.6, 1.0), ("rear_right", -2.6, -1.0)];
    let both = axles(&[front, rear].concat());
    let (_folder, output) = compare(&both, &axles(&rear), &[]);
    let report = text(&output.stdout);
    let expected = "only A has: all of `front_left`, all of `front_right`\n";
    assert!(report.contains(expected), "{report}");
    assert!(!report.contains("only B has"), "{report}");
}

/// If nothing differs, no place of the largest difference is named.
#[test]
fn a_difference_within_rounding_has_no_place() {
    let (_folder, output) = compare(CORNER, CORNER, &[]);
    let report = text(&output.stdout);
    let (_, over) = report
        .split_once("Largest difference over bump")
        .expect("curves");
    let camber = over
        .lines()
        .find(|line| line.trim_start().starts_with("camber angle "));
    let words: Vec<&str> = camber.expect("a line").split_whitespace().collect();
    assert!(
        words.ends_with(&["0", "deg", "everywhere", "0"]),
        "{report}"
    );
    let (_folder, output) = compare(CORNER, CORNER, &["--csv", "-"]);
    assert!(
        rows(&output).iter().all(|(_, [at, ..])| at.is_nan()),
        "{output:?}"
    );
    let moved = format!("{CORNER}[points]\nupper_ball = [-0.015, 0.65, 0.44]\n");
    let (_folder, output) = compare(CORNER, &moved, &["--csv", "-"]);
    for ([of, quantity, _], [at, a, b, difference]) in rows(&output) {
        let differs = difference.abs() > 1e-11 * a.abs().max(b.abs()).max(1.0);
        let has_place = of.starts_with("over") && differs;
        assert_eq!(at.is_finite(), has_place, "{of} {quantity}");
    }
}

/// The two examples have the same links; the instant centre in the side view is 111 m away, where rounding made a
/// difference of 1.2e-12 m.
#[test]
fn a_difference_that_is_only_rounding_is_zero() {
    let coilover = include_str!("../../../examples/double_wishbone_coilover.toml");
    let rocker = include_str!("../../../examples/double_wishbone_rocker.toml");
    let (_folder, output) = compare(coilover, rocker, &["--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let rows = rows(&output);
    assert!(rows.len() > 100, "{}", rows.len());
    for ([of, quantity, _], [_, _, _, difference]) in rows {
        assert!(
            difference == 0.0 || difference.abs() > 1e-9,
            "{of}, {quantity}: {difference}"
        );
        let differs = difference != 0.0;
        assert_eq!(differs, quantity.contains("damper"), "{of}, {quantity}");
    }
}

/// Evenly spaced places of these ranges miss the design position.
#[test]
fn curves_that_are_equal_are_shown_with_the_values_of_the_design() {
    let file = "linkage = \"double_wishbone_coilover\"\nunit = \"m\"\ntime = { instants = [0.0] }\n[drives]\nbump = 0.3\nsteer = 0.34\n";
    let ranges = ["--travel=-0.047:0.06", "--steer=-0.011:0.02"];
    let (_folder, output) = compare(file, file, &[&["--csv", "-"], &ranges[..]].concat());
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let rows = rows(&output);
    let value = |of: &str, quantity: &str| {
        let found = rows.iter().find(|(names, _)| names[..2] == [of, quantity]);
        found.map(|(_, [_, a, ..])| *a)
    };
    let mut count = 0;
    for ([of, quantity, _], [.., a, _, _]) in &rows {
        if let (true, Some(design)) = (of.starts_with("over"), value("design", quantity)) {
            assert!((a - design).abs() < 1e-12, "{of} {quantity}: {a}, {design}");
            count += 1;
        }
    }
    assert!(count > 20, "{count}");
}
