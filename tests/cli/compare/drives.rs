//! Which drives and which wheels of two files are compared with each other.

use super::super::program::{CORNER, text};
use super::axles::axles;
use super::{arm, compare, rows};

/// Without a wheel, a length and an angle as drives cannot be compared.
#[test]
fn without_a_wheel_travel_by_height_and_by_angle_is_not_compared() {
    let angle = arm("m", 1.0, 0.4)
        .replace("drive bump: tip.z", "drive bump: angle(front -> tip, z)")
        .replace("bump = 0.0", "bump = 1.5");
    let (_folder, output) = compare(&arm("m", 1.0, 0.4), &angle, &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report = text(&output.stdout);
    assert!(
        report.contains("`bump` of A is a length, `bump` of B an angle: no curves"),
        "{report}"
    );
    assert!(
        report.contains("At the design position\n") && !report.contains("over travel"),
        "{report}"
    );
}

#[test]
fn a_drive_of_only_one_file_is_named() {
    let (_folder, output) = compare(CORNER, &arm("m", 1.0, 0.4), &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report = text(&output.stdout);
    assert!(
        report.contains("B has nothing like `steer`: no curves over it are compared"),
        "{report}"
    );
}

/// A skewed arm, led by the wheel's height, with a damper.
pub(super) fn led_by(drive: &str, value: f64) -> String {
    format!(
        "unit = \"mm\"\nangle = \"deg\"\nstatements = '''
fixed: pin at [420, 230, 310], pout at [330, 600, 285], top at [-70, 560, 690];
free:  wheel_centre at [3, 735, 301], low at [-95, 590, 240];
hinge arm: pin, pout -> wheel_centre, low;
point axle: arm at [1, 610, 303];
drive bump: {drive};
measure damper: length(low -> top);
wheel: axle -> wheel_centre;
'''
vehicle = {{ wheel_radius = 298 }}
time = {{ instants = [0.0] }}
drives = {{ bump = {value:?} }}
"
    )
}

/// With its damper held, a steered wheel rises and falls.
#[test]
fn a_wheel_height_that_varies_in_steering_is_reported() {
    let listing =
        include_str!("../../../suspension-core/src/linkages/double_wishbone_pushrod.linkage");
    let by_damper = listing.replace("wheel_centre.z;", "length(damper_inner -> damper_outer);");
    assert_ne!(listing, by_damper);
    let stated = format!("statements = \"\"\"\n{by_damper}\"\"\"\n");
    let by_damper = CORNER.replace("linkage = \"double_wishbone_pushrod\"\n", &stated);
    let by_damper = by_damper.replace("bump = 0.3", "bump = 0.24083189157584592");
    let options = ["--travel", "-0.01:0.01"];
    let expected = "the drive of travel of A keeps the height of the wheel centre in steering, that of B does not";
    let (_folder, output) = compare(CORNER, &by_damper, &options);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(text(&output.stdout).contains(expected), "{output:?}");
    let (_folder, output) = compare(&by_damper, &by_damper, &options);
    assert!(!text(&output.stdout).contains("in steering"), "{output:?}");
}

#[test]
fn travel_is_compared_upwards_whatever_the_sign_of_the_drive() {
    let up = led_by("wheel_centre.z", 301.0);
    let down = led_by("-1 wheel_centre.z", -301.0);
    let (_folder, output) = compare(&up, &down, &["--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let mut count = 0;
    for ([of, quantity, _], [_, a, b, difference]) in rows(&output) {
        if of == "over travel" && !quantity.starts_with("motion ratio") {
            assert!(
                difference.abs() < 1e-7 * (1.0 + a.abs()),
                "{quantity}: {a} {b}"
            );
            count += 1;
        }
    }
    assert!(count > 10, "{count}");
}

/// One suspension, driven by the height of its wheel and by its damper: over the travel of the wheel there is no difference.
#[test]
fn travel_driven_by_a_damper_is_compared_over_wheel_travel() {
    let up = led_by("wheel_centre.z", 301.0);
    let by_damper = led_by("length(low -> top)", 451.691_266_242_773_4);
    let (_folder, output) = compare(&up, &by_damper, &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report = text(&output.stdout);
    for expected in [
        "the wheel rises by 1 per unit of `bump` of A and by 0.6",
        "of `bump upwards` of B: the curves are compared over the travel of the wheel, as far as both go",
        "Largest difference over wheel travel, at a wheel travel (mm)",
    ] {
        assert!(report.contains(expected), "{expected}: {report}");
    }
    let output = compare(&up, &by_damper, &["--csv", "-"]).1;
    let rows = rows(&output);
    for (of, tolerance) in [("per wheel travel", 1e-9), ("over wheel travel", 1e-7)] {
        let by_wheel = || rows.iter().filter(|([part, ..], _)| part == of);
        let camber = by_wheel().find(|([_, quantity, _], _)| quantity == "camber angle");
        assert!(camber.is_some_and(|(_, [_, a, ..])| a.abs() > 0.01));
        for (names, [_, a, b, difference]) in by_wheel() {
            assert!(
                difference.abs() < tolerance * (1.0 + a.abs()),
                "{names:?}: {a} {b}"
            );
        }
    }
    let ratio = "motion ratio: damper per wheel travel";
    assert!(
        rows.iter()
            .any(|([_, quantity, unit], _)| quantity == ratio && unit == "mm/mm")
    );
    assert!(!rows.iter().any(|([of, ..], _)| of == "over travel"));
}

/// A length and an angle have no equal changes, but both lift the wheel.
#[test]
fn travel_driven_by_an_angle_is_compared_over_wheel_travel() {
    let height = led_by("wheel_centre.z", 301.0);
    let angle = led_by("angle(pin -> wheel_centre, z)", 90.787);
    let (folder, output) = compare(&height, &angle, &["--html", "a.html"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report = text(&output.stdout);
    let expected = "`bump` of A is a length, `bump upwards` of B an angle: the curves are compared over the travel of the wheel";
    assert!(report.contains(expected), "{report}");
    let heading = "Largest difference over wheel travel, at a wheel travel (mm)\n";
    let (_, over) = report.split_once(heading).expect(heading);
    let mut lines = over.lines();
    let camber = lines.find(|line| line.trim_start().starts_with("camber angle "));
    let camber = camber.expect("camber").split_whitespace().nth(4);
    let difference: f64 = camber.expect("a difference").parse().expect("a number");
    assert!(difference.abs() < 1e-6, "{report}");
    let page = std::fs::read_to_string(folder.path().join("a.html")).expect("a page");
    assert!(page.contains("Over wheel travel") && page.contains("wheel travel (mm)"));
}

/// The headings of derivatives, each with the moved wheels.
#[test]
fn headings_of_compared_derivatives_name_the_moved_wheels() {
    let front = [("front_left", 0.0, 1.0), ("front_right", 0.0, -1.0)];
    let [left, right] = [("left", 0.0, 1.0), ("right", 0.0, -1.0)];
    let (four, two) = (axles(&front), axles(&[left, right]));
    let damper = led_by("length(low -> top)", 451.691_266_242_773_4);
    // Drives that are half the height.
    let half = |file: &str| {
        file.replace("_bump: ", "_bump: 0.5 ")
            .replace("_bump = 0.3", "_bump = 0.15")
    };
    let (one, halves) = (axles(&[("", 0.0, 1.0)]), half(&two));
    for (a, b, expected) in [
        (
            &four,
            &two,
            "per travel of the front right wheel in A, travel of the right wheel in B",
        ),
        (&two, &two, "per travel of the right wheel"),
        (&damper, &damper, "per change of bump at the wheel"),
        (
            &halves,
            &halves,
            "per change of right_bump at the right wheel",
        ),
        (
            &half(&one),
            &halves,
            "per change of _bump at the wheel in A, change of each wheel's own drive in B",
        ),
        (
            &one,
            &two,
            "per travel of the wheel in A, travel of each wheel by its own drive in B",
        ),
    ] {
        let (_folder, output) = compare(a, b, &[]);
        let report = text(&output.stdout);
        let expected = format!("\nAt the design position, {expected}\n");
        assert!(report.contains(&expected), "{expected}: {output:?}");
    }
}

/// The rack of one is positive to the left, that of the other to the right.
#[test]
fn racks_of_opposite_sign_are_reported() {
    let listing = include_str!("../../../suspension-core/src/linkages/double_wishbone.linkage");
    let led_by = |steer: &str, at: f64| {
        let listing = listing.replace("drive steer: rack.y;", &format!("drive steer: {steer};"));
        assert!(listing.contains(steer), "{listing}");
        format!(
            "unit = \"m\"\nstatements = '''{listing}'''\nvehicle = {{ wheel_radius = 0.3 }}\ntime = {{ instants = [0.0] }}\n\
             drives = {{ bump = 0.3, steer = {at:?} }}\n"
        )
    };
    let (left, right) = (
        led_by("rack.y", 0.34),
        led_by("rack along [0, -1, 0]", -0.34),
    );
    let note = "`steer` of A and `steer` of B turn the wheels opposite ways: this causes most differences per steer and over steer";
    for (b, is_reported) in [(&right, true), (&left, false)] {
        let (_folder, output) = compare(&left, b, &[]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        assert_eq!(
            text(&output.stdout).contains(note),
            is_reported,
            "{output:?}"
        );
    }
}
