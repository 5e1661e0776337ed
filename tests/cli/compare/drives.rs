//! Which drives and which wheels of two files are compared with each other.

use super::super::program::{CORNER, text};
use super::{arm, compare, rows};

#[test]
fn a_travel_by_height_and_one_by_angle_are_not_mixed() {
    let angle = arm("m", 1.0, 0.4)
        .replace("drive bump: tip.z", "drive bump: angle(front -> tip, z)")
        .replace("bump = 0.0", "bump = 1.5");
    let (_folder, output) = compare(&arm("m", 1.0, 0.4), &angle, &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report = text(&output.stdout);
    assert!(
        report.contains("`bump` of A is a length, `bump` of B an angle"),
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

#[test]
fn travel_by_a_damper_is_not_that_of_the_wheel() {
    let up = led_by("wheel_centre.z", 301.0);
    let by_damper = led_by("length(low -> top)", 451.691_266_242_773_4);
    let (_folder, output) = compare(&up, &by_damper, &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report = text(&output.stdout);
    let said = "the wheel rises by 1 per unit of `bump` of A and by 0.6";
    assert!(report.contains(said), "{report}");
    assert!(report.contains("of `bump upwards` of B"), "{report}");
    // It is one suspension: per travel of the wheel there is no difference.
    let (_folder, output) = compare(&up, &by_damper, &["--csv", "-"]);
    let rows = rows(&output);
    let by_wheel = || rows.iter().filter(|([of, ..], _)| of == "per wheel travel");
    let camber = by_wheel().find(|([_, quantity, _], _)| quantity == "camber angle");
    assert!(camber.is_some_and(|(_, [_, a, ..])| a.abs() > 0.01));
    for (names, [_, a, b, difference]) in by_wheel() {
        assert!(
            difference.abs() < 1e-9 * (1.0 + a.abs()),
            "{names:?}: {a} {b}"
        );
    }
    assert!(report.contains(
        "what is compared over travel is at equal changes of the drives, not of the wheels"
    ));
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
fn axles(wheels: &[(&str, f64, f64)]) -> String {
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
