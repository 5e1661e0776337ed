//! Which drives and which wheels of two files are compared with each other.

use super::super::program::{CORNER, text};
use super::{arm, compare, rows};

/// Without a wheel nothing tells how a length and an angle move it alike.
#[test]
fn a_travel_by_height_and_one_by_angle_are_not_mixed() {
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
fn a_drive_that_only_one_of_the_files_has_is_named() {
    let (_folder, output) = compare(CORNER, &arm("m", 1.0, 0.4), &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report = text(&output.stdout);
    assert!(
        report.contains("B has nothing like `steer`: no curves over it are compared"),
        "{report}"
    );
}

/// A skewed arm, led by the wheel's height, with a damper.
fn led_by(drive: &str, value: f64) -> String {
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

/// Held by its damper, a steered wheel rises and falls.
#[test]
fn what_steering_holds_is_told_where_it_is_not_the_same() {
    let listing =
        include_str!("../../../suspension-core/src/linkages/double_wishbone_pushrod.linkage");
    let by_damper = listing.replace("wheel_centre.z;", "length(damper_inner -> damper_outer);");
    assert_ne!(listing, by_damper);
    let stated = format!("statements = \"\"\"\n{by_damper}\"\"\"\n");
    let by_damper = CORNER.replace("linkage = \"double_wishbone_pushrod\"\n", &stated);
    let by_damper = by_damper.replace("bump = 0.3", "bump = 0.24083189157584592");
    let options = ["--travel", "-0.01:0.01"];
    let said = "the drive of travel of A keeps the height of the wheel centre in steering, that of B does not";
    let (_folder, output) = compare(CORNER, &by_damper, &options);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(text(&output.stdout).contains(said), "{output:?}");
    let (_folder, output) = compare(&by_damper, &by_damper, &options);
    assert!(!text(&output.stdout).contains("in steering"), "{output:?}");
}

#[test]
fn travel_goes_upwards_whatever_the_drive_counts() {
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

/// One suspension, led by the height of its wheel and by its damper: over the travel of the wheel there is no difference.
#[test]
fn travel_by_a_damper_is_compared_over_that_of_the_wheel() {
    let up = led_by("wheel_centre.z", 301.0);
    let by_damper = led_by("length(low -> top)", 451.691_266_242_773_4);
    let (_folder, output) = compare(&up, &by_damper, &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report = text(&output.stdout);
    for said in [
        "the wheel rises by 1 per unit of `bump` of A and by 0.6",
        "of `bump upwards` of B: the curves are compared over the travel of the wheel, as far as both go",
        "Largest difference over wheel travel, at a wheel travel (mm)",
    ] {
        assert!(report.contains(said), "{said}: {report}");
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
fn travel_by_an_angle_is_compared_over_that_of_the_wheel() {
    let height = led_by("wheel_centre.z", 301.0);
    let angle = led_by("angle(pin -> wheel_centre, z)", 90.787);
    let (folder, output) = compare(&height, &angle, &["--html", "a.html"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report = text(&output.stdout);
    let said = "`bump` of A is a length, `bump upwards` of B an angle: the curves are compared over the travel of the wheel";
    assert!(report.contains(said), "{report}");
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

/// The catalogue's axle is its corner, left and right.
#[test]
fn a_wheel_without_a_name_is_compared_with_each_wheel_of_an_axle() {
    let corner = CORNER.replace("double_wishbone_pushrod", "double_wishbone");
    let axle = CORNER
        .replace("double_wishbone_pushrod", "steered_axle")
        .replace("bump = 0.3", "bump_left = 0.3\nbump_right = 0.3");
    let columns = |a: &str, b: &str| {
        let (_folder, output) = compare(a, b, &["--csv", "-"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        rows(&output)
    };
    let [by_corner, by_axle] = [columns(&corner, &axle), columns(&axle, &corner)];
    assert_eq!(by_corner.len(), by_axle.len());
    for rows in [by_corner, by_axle] {
        for of in ["design", "per travel", "over travel"] {
            for quantity in ["left camber angle", "right camber angle", "right toe angle"] {
                let row = rows
                    .iter()
                    .find(|(names, _)| names[0] == of && names[1] == quantity);
                let (_, [_, a, _, difference]) =
                    row.unwrap_or_else(|| panic!("no {of} {quantity}"));
                assert!(difference.abs() < 1e-9, "{of} {quantity}: {difference}");
                assert!(of != "per travel" || a.abs() > 0.1, "{of} {quantity}: {a}");
            }
        }
    }
}

/// Arms of two axles, each driven by its height; the wheels are stated in any order.
pub(super) fn axles(wheels: &[(&str, f64, f64)]) -> String {
    let (mut statements, mut drives) = (String::new(), String::new());
    for (wheel, x, side) in wheels {
        let at = |x: f64, y: f64, z: f64| format!("[{x:?}, {:?}, {z:?}]", y * side);
        statements += &format!(
            "fixed: {wheel}_fore at {}, {wheel}_aft at {};\nfree: {wheel}_hub at {};\n\
             hinge {wheel}_arm: {wheel}_fore, {wheel}_aft -> {wheel}_hub;\npoint {wheel}_in: {wheel}_arm at {};\n\
             drive {wheel}_bump: {wheel}_hub.z;\nwheel {wheel}: {wheel}_in -> {wheel}_hub;\n",
            at(x + 0.2, 0.30, 0.25),
            at(x - 0.2, 0.35, 0.22),
            at(*x, 0.70, 0.30),
            at(*x, 0.60, 0.30),
        );
        drives += &format!("{wheel}_bump = 0.3\n");
    }
    format!(
        "unit = \"m\"\nstatements = \"\"\"\n{statements}\"\"\"\nvehicle = {{ wheel_radius = 0.3 }}\n\
         time = {{ instants = [0.0] }}\n[drives]\n{drives}"
    )
}

/// What is compared of two files, without places and differences.
fn assert_same(a: &str, b: &str, wanted: &str) {
    let (_folder, output) = compare(a, b, &["--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let mut count = 0;
    for ([of, quantity, _], [_, a, b, difference]) in rows(&output) {
        if of != "design" && quantity.contains(wanted) && !quantity.ends_with(" x") {
            assert!(
                difference.abs() < 1e-9 * (1.0 + a.abs()),
                "{of} {quantity}: {a} {b}"
            );
            count += usize::from(a.abs() > 1e-3);
        }
    }
    assert!(count > 1, "{wanted}: {count}");
}

#[test]
fn wheels_of_one_name_are_compared_along_their_own_drives() {
    let (left, right) = (("left", 0.0, 1.0), ("right", 0.0, -1.0));
    // In roll the left wheel rises, whichever is stated first.
    assert_same(&axles(&[left, right]), &axles(&[right, left]), "left");
    let front = [("front_left", 0.0, 1.0), ("front_right", 0.0, -1.0)];
    let rear = [("rear_left", -2.6, 1.0), ("rear_right", -2.6, -1.0)];
    let both = axles(&[front, rear].concat());
    assert_same(&both, &axles(&rear), "rear_left camber");
    // Axles are compared by their names, whichever is stated first.
    let exchanged = axles(&[rear, front].concat());
    let (_folder, output) = compare(&both, &exchanged, &["--csv", "-"]);
    let over = |([of, quantity, _], _): &&([String; 3], [f64; 4])| {
        of.starts_with("over") && quantity.ends_with("camber angle")
    };
    let rows = rows(&output);
    assert_eq!(rows.iter().filter(over).count(), 8, "{rows:?}");
    for (names, [_, a, b, difference]) in rows.iter().filter(over) {
        assert!(difference.abs() < 1e-9, "{names:?}: {a} {b}");
    }
    // An axle without a name beside one of several.
    let alone = axles(&[left, right]);
    assert_same(&both, &alone, "rear roll centre");
    assert_same(&alone, &both, "rear roll centre");
}

/// Heave moves both wheels and roll lifts one as the other falls; each wheel's own height moves it alone.
#[test]
fn drives_in_heave_and_roll_are_compared_per_travel_of_each_wheel() {
    let heights = axles(&[("left", 0.0, 1.0), ("right", 0.0, -1.0)]);
    let mut modes = heights.clone();
    for (of_height, of_mode) in [
        (
            "drive left_bump: left_hub.z;",
            "drive heave: 0.5 left_hub.z + 0.5 right_hub.z;",
        ),
        (
            "drive right_bump: right_hub.z;",
            "drive roll: left_hub.z - right_hub.z;",
        ),
        (
            "left_bump = 0.3\nright_bump = 0.3",
            "heave = 0.3\nroll = 0.0",
        ),
        (
            "= 0.3 }",
            "= 0.3, travel = { left = \"heave\", right = \"roll\" } }",
        ),
    ] {
        assert!(modes.contains(of_height), "{modes}");
        modes = modes.replace(of_height, of_mode);
    }
    let corner = axles(&[("", 0.0, 1.0)]);
    for (a, b, wheels) in [
        (&heights, &modes, 2),
        (&modes, &heights, 2),
        (&corner, &modes, 1),
    ] {
        let (_folder, output) = compare(a, b, &["--csv", "-"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let rows = rows(&output);
        let derivatives = || rows.iter().filter(|([of, ..], _)| of.starts_with("per "));
        for (names, [_, a, b, difference]) in derivatives() {
            let [of, quantity, _] = names;
            assert!(of.starts_with("per wheel travel"), "{names:?}");
            // The other side of the vehicle has the other sign.
            let is_along_y =
                wheels == 1 && (quantity.ends_with(" y") || quantity.contains("pitch"));
            let difference = if is_along_y {
                a.abs() - b.abs()
            } else {
                *difference
            };
            assert!(
                difference.abs() < 1e-9 * (1.0 + a.abs()),
                "{names:?}: {a} {b}"
            );
        }
        let camber = |([_, quantity, _], [_, a, ..]): &&([String; 3], [f64; 4])| {
            quantity.ends_with("camber angle") && a.abs() > 0.1
        };
        assert_eq!(derivatives().filter(camber).count(), 2, "{rows:?}");
    }
    let (_folder, output) = compare(&modes, &modes, &["--csv", "-"]);
    let of_modes = rows(&output);
    assert!(
        !of_modes
            .iter()
            .any(|([of, ..], _)| of.contains("per wheel"))
    );
}

/// The headings of derivatives, each with what moves.
#[test]
fn what_moves_is_named_above_derivatives() {
    let front = [("front_left", 0.0, 1.0), ("front_right", 0.0, -1.0)];
    let [left, right] = [("left", 0.0, 1.0), ("right", 0.0, -1.0)];
    let (four, two) = (axles(&front), axles(&[left, right]));
    let damper = led_by("length(low -> top)", 451.691_266_242_773_4);
    for (a, b, expected) in [
        (
            &four,
            &two,
            "per travel 2 (wheel front_right of A, wheel right of B)",
        ),
        (&two, &two, "per travel 2 (wheel right)"),
        (&damper, &damper, "per travel (bump)"),
        (
            &axles(&[("", 0.0, 1.0)]),
            &two,
            "per travel (_bump of A, each wheel by its own drive of B)",
        ),
    ] {
        let (_folder, output) = compare(a, b, &[]);
        let report = text(&output.stdout);
        let expected = format!("\nAt the design position, {expected}\n");
        assert!(report.contains(&expected), "{expected}: {output:?}");
    }
}

#[test]
fn wheels_on_opposite_sides_are_named() {
    let corner = |side| axles(&[("", 0.0, side)]);
    let both = axles(&[("left", 0.0, 1.0), ("right", 0.0, -1.0)]);
    for (a, b, expected) in [
        (&corner(1.0), &corner(-1.0), "\nthe wheels are on opposite"),
        (
            &corner(1.0),
            &both,
            "\nthe wheel of A and `right` of B are on opposite",
        ),
        (
            &both,
            &corner(-1.0),
            "\n`left` of A and the wheel of B are on opposite",
        ),
    ] {
        let (_folder, output) = compare(a, b, &[]);
        let report = text(&output.stdout);
        assert!(report.contains(expected), "{expected}: {output:?}");
    }
    let (_folder, output) = compare(&both, &both, &[]);
    assert!(
        !text(&output.stdout).contains("opposite sides"),
        "{output:?}"
    );
}

/// The rack of one is counted to the left, that of the other to the right.
#[test]
fn racks_that_are_counted_opposite_ways_are_told() {
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
    let note = "where `steer` of A and `steer` of B grow they turn the wheels opposite ways: most of what differs per steer and over steer is \
                the opposite direction\n";
    for (b, is_told) in [(&right, true), (&left, false)] {
        let (_folder, output) = compare(&left, b, &[]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        assert_eq!(text(&output.stdout).contains(note), is_told, "{output:?}");
    }
}
