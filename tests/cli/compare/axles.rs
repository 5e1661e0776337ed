//! `suspension compare` of axles: which wheel is compared with which.

use super::super::program::{CORNER, text};
use super::{compare, rows};

/// The catalogue's axle is its corner, left and right.
#[test]
fn an_unnamed_wheel_is_compared_with_each_wheel_of_an_axle() {
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

#[test]
fn the_damper_of_an_unnamed_wheel_is_compared_with_that_of_each_wheel() {
    let with_dampers = |wheels: &[(&str, &str, f64)]| {
        let arms: Vec<_> = wheels
            .iter()
            .map(|(wheel, _, side)| (*wheel, 0.0, *side))
            .collect();
        let dampers = wheels.iter().map(|(wheel, damper, side)| {
            let y = 0.4 * side;
            format!("fixed: {wheel}_top at [0.1, {y:?}, 0.8];\nmeasure {damper}: length({wheel}_hub -> {wheel}_top);\n")
        });
        let dampers: String = dampers.collect();
        axles(&arms).replacen("\"\"\"\n", &format!("\"\"\"\n{dampers}"), 1)
    };
    let corner = with_dampers(&[("", "damper", 1.0)]);
    let axle = with_dampers(&[
        ("left", "left_damper", 1.0),
        ("right", "damper_right", -1.0),
    ]);
    let (_folder, output) = compare(&corner, &axle, &["--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let rows = rows(&output);
    for of in ["design", "per travel", "over travel"] {
        for quantity in ["left damper", "right damper"] {
            let mut found = rows
                .iter()
                .filter(|(names, _)| names[..2] == [of, quantity]);
            let (_, [_, a, _, difference]) = found.next().expect(quantity);
            assert!(
                a.abs() > 0.1 && difference.abs() < 1e-12,
                "{of} {quantity}: {a} {difference}"
            );
        }
    }
}

/// Asserts the compared quantities of two files, without places and differences.
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
fn wheels_of_the_same_name_are_compared_along_their_own_drives() {
    let (left, right) = (("left", 0.0, 1.0), ("right", 0.0, -1.0));
    // In roll the left wheel rises, in any order of the statements.
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
    // An axle without a name is compared with one of several.
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

/// The roll centres of these axles differ, the toe of their wheels in heave does not.
#[test]
fn wheels_with_the_same_numbers_share_a_row_for_people() {
    let [a, b] = [
        include_str!("../../../examples/live_axle_watt.toml"),
        include_str!("../../../examples/live_axle_panhard.toml"),
    ];
    let (_folder, output) = compare(a, b, &[]);
    let report = text(&output.stdout);
    let (_, design) = report.split_once("At the design position\n").expect("it");
    let (design, _) = design.split_once("per travel").expect("its end");
    let begin = |name: &str| {
        let lines = design.lines();
        lines
            .filter(|line| line.trim_start().starts_with(name))
            .count()
    };
    for (name, rows) in [
        ("left and right damper ", 1),
        ("left damper ", 0),
        ("right damper ", 0),
        ("left wheel centre y ", 1),
        ("right wheel centre y ", 1),
        ("left support angle of outboard brakes ", 1),
        ("right support angle of outboard brakes ", 1),
    ] {
        assert_eq!(begin(name), rows, "{name}: {design}");
    }
    let (folder, output) = compare(a, b, &["--csv", "-", "--html", "c.html"]);
    let of_damper = |wheel: &str| {
        let quantity = format!("{wheel} damper");
        let rows = rows(&output).into_iter();
        let mut rows = rows.filter(|(names, _)| names[0] == "design" && names[1] == quantity);
        rows.next().map(|(_, numbers)| (numbers[1], numbers[2]))
    };
    assert!(of_damper("left").is_some());
    assert_eq!(of_damper("left"), of_damper("right"));
    let page = std::fs::read_to_string(folder.path().join("c.html")).expect("a page");
    assert!(page.contains("<td>left and right damper</td>"));
}
