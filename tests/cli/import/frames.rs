//! Axes and sides.

use std::collections::BTreeMap;

use suspension_core::linkages::LISTINGS;

use super::super::program::folder;
use super::refused::refusal;
use super::{CORNER, IN_OUR_AXES, Imported, import, listed, table};

/// The corner with its coordinates multiplied, x, y, z, and a prefix before its names.
fn corner(prefix: &str, signs: [f64; 3]) -> String {
    let points = CORNER.map(|(name, at)| {
        let at = [0, 1, 2].map(|axis| at[axis] * signs[axis]);
        (format!("{prefix}{name}"), at)
    });
    let points = points.each_ref().map(|(name, at)| (name.as_str(), *at));
    table(&points)
}

/// The points in our axes, y multiplied.
fn expected(y: f64) -> BTreeMap<String, [f64; 3]> {
    let points = IN_OUR_AXES.map(|(name, at)| (name.to_owned(), [at[0], at[1] * y, at[2]]));
    points.into()
}

#[test]
fn axes_are_inferred_from_the_order_of_points_and_named() {
    let folder = folder();
    for (axes, signs) in [
        (
            "Adams (x rearward, y right, z up), as x is -140 at `lca_front` and 150 at",
            [1.0, 1.0, 1.0],
        ),
        (
            "ISO 8855 (x forward, y left, z up), as x is 140 at `lca_front` and -150 at",
            [-1.0, -1.0, 1.0],
        ),
        (
            "SAE (x forward, y right, z down), as x is 140 at `lca_front` and -150 at",
            [-1.0, 1.0, -1.0],
        ),
    ] {
        let imported = import(folder.path(), "a.csv", &corner("", signs), &[]);
        assert_eq!(imported.points(), expected(1.0));
        let expected_text = format!("note: a.csv: axes are {axes}");
        assert!(
            imported.notes.contains(&expected_text),
            "{}",
            imported.notes
        );
    }
}

/// A published layout has the same names, and its front links behind the rear ones.
#[test]
fn axes_of_a_five_link_suspension_are_inferred() {
    let folder = folder();
    let listed = listed("multi_link");
    for (signs, axes) in [([1.0, 1.0], "ISO 8855"), ([-1.0, -1.0], "Adams")] {
        let points = listed
            .iter()
            .map(|(name, [x, y, z])| (name.as_str(), [signs[0] * x, signs[1] * y, *z]));
        let points: Vec<_> = points.collect();
        let imported = import(folder.path(), "a.csv", &table(&points), &[]);
        assert_eq!(imported.text("linkage"), "multi_link");
        assert_eq!(
            imported.points(),
            listed.iter().cloned().collect(),
            "{axes}"
        );
        let expected = format!("note: a.csv: axes are {axes} (");
        assert!(imported.notes.contains(&expected), "{}", imported.notes);
    }
}

/// Without a pair of points for the layout its axes would be taken as usual, without a doubt.
#[test]
fn axes_are_deduced_in_every_layout_whose_names_say_front_and_upper() {
    let folder = folder();
    let without = [
        "attia2003",
        "five_link",
        "steered_axle",
        "front_and_rear_axle",
    ];
    let layouts = LISTINGS.iter().map(|(linkage, _)| *linkage);
    for linkage in layouts.filter(|linkage| !without.contains(linkage)) {
        let listed = listed(linkage);
        for signs in [[1.0, 1.0, 1.0], [-1.0, -1.0, 1.0], [1.0, -1.0, -1.0]] {
            let points = listed.iter().map(|(name, at)| {
                let at = [0, 1, 2].map(|axis| at[axis] * signs[axis]);
                (name.as_str(), at)
            });
            let points: Vec<_> = points.collect();
            let imported = import(folder.path(), "a.csv", &table(&points), &[]);
            assert_eq!(
                imported.points(),
                listed.iter().cloned().collect(),
                "{linkage} {signs:?} {}",
                imported.notes
            );
        }
    }
}

#[test]
fn stated_axes_are_used_and_a_contradiction_by_points_is_noted() {
    let folder = folder();
    let imported = import(
        folder.path(),
        "a.csv",
        &corner("", [1.0; 3]),
        &["--axes", "ISO"],
    );
    let as_listed = expected(-1.0).into_iter();
    let as_listed = as_listed.map(|(name, [x, y, z])| (name, [0.0 - x, y, z]));
    assert_eq!(imported.points(), as_listed.collect());
    assert!(
        imported.notes.contains(
            "that is doubtful, as x is -140 at `lca_front` and 150 at `lca_rear` behind it"
        ),
        "{}",
        imported.notes
    );
}

#[test]
fn a_mistyped_coordinate_does_not_turn_the_axes() {
    let folder = folder();
    let file = corner("", [1.0; 3]);
    for (row, other, doubt) in [
        (
            "uca_outer, 14, -535, 330",
            "uca_outer, 14, -535, 33",
            "z is 33 at `uca_outer` and 128 at `lca_outer` below it",
        ),
        (
            "lca_rear, 150,",
            "lca_rear, -150,",
            "x is -140 at `lca_front` and -150 at `lca_rear` behind it",
        ),
    ] {
        let mistyped = file.replace(row, other);
        assert_ne!(mistyped, file);
        let notes = import(folder.path(), "a.csv", &mistyped, &[]).notes;
        let doubt = format!(
            "note: a.csv: {doubt}: is a coordinate mistyped, or have they each other's names?\n"
        );
        for said in ["axes are Adams (x rearward, y right, z up)", &*doubt] {
            assert!(notes.contains(said), "{notes}");
        }
    }
}

#[test]
fn an_imported_corner_keeps_its_side_unless_the_other_is_requested() {
    let folder = folder();
    let right = [1.0, -1.0, 1.0];
    for (file, options, y, expected_text) in [
        (
            corner("hpl_", [1.0; 3]),
            vec![],
            1.0,
            "the corner is the left one",
        ),
        (
            corner("hpr_", right),
            vec![],
            -1.0,
            "the corner is the right one",
        ),
        (
            corner("", right),
            vec![],
            -1.0,
            "the corner is the right one",
        ),
        (
            corner("", right),
            vec!["--side", "left"],
            1.0,
            "the coordinates are those of the right corner; the left corner is its mirror image, as the options ask",
        ),
        (
            corner("hpl_", [1.0; 3]),
            vec!["--side", "right"],
            -1.0,
            "the coordinates are those of the left corner; the right corner is its mirror image, as the options ask",
        ),
        (
            corner("hpl_", [1.0; 3]),
            vec!["--side", "left"],
            1.0,
            "the corner is the left one",
        ),
        // Both corners are there.
        (
            corner("hpl_", [1.0; 3]) + &corner("hpr_", right),
            vec![],
            1.0,
            "the corner is the left one",
        ),
        (
            corner("hpl_", [1.0; 3]) + &corner("hpr_", right),
            vec!["--side", "right"],
            -1.0,
            "the corner is the right one",
        ),
    ] {
        let imported = import(folder.path(), "a.csv", &file, &options);
        assert_eq!(imported.points(), expected(y), "{expected_text}");
        assert!(imported.notes.contains(expected_text), "{}", imported.notes);
        let axle = imported.motion["points"]["axle"]["offset"][1].as_float();
        assert_eq!(axle, Some(-100.0 * y));
    }
}

/// Returns the tangents of toe and camber from the offset of an axle point from its wheel centre.
fn angles(imported: &Imported, axle: &str) -> [f64; 2] {
    let offset = imported.motion["points"][axle]["offset"].as_array();
    let offset = offset.expect("three").iter();
    let offset: Vec<f64> = offset.filter_map(toml::Value::as_float).collect();
    [
        -offset[0] / offset[1].abs(),
        offset[2] / offset[0].hypot(offset[1]),
    ]
}

fn assert_angles(imported: &Imported, axle: &str, degrees: [f64; 2]) {
    let [toe, camber] = degrees.map(|angle| angle.to_radians().tan());
    let found = angles(imported, axle);
    assert!(
        (found[0] - toe).abs() < 1e-15 && (found[1] - camber).abs() < 1e-15,
        "{axle}: {found:?}"
    );
}

#[test]
fn a_column_of_sides_may_contain_initials() {
    let folder = folder();
    let of = |side: &str, y: f64| {
        let rows = corner("", [1.0, y, 1.0]);
        let rows = rows
            .lines()
            .map(|row| row.replacen(", ", &format!(", {side}, "), 1));
        rows.collect::<Vec<_>>().join("\n") + "\n"
    };
    let file = of("L", 1.0) + &of("r", -1.0);
    for (side, y) in [("left", 1.0), ("right", -1.0)] {
        let imported = import(folder.path(), "a.csv", &file, &["--side", side]);
        assert_eq!(imported.points(), expected(y));
        let expected_text = format!("the corner is the {side} one");
        assert!(
            imported.notes.contains(&expected_text),
            "{}",
            imported.notes
        );
    }
}

#[test]
fn a_mirrored_corner_keeps_the_angles_and_radius_of_the_original() {
    let folder = folder();
    let numbers = "toe_angle, left, 0.4\ncamber_angle, left, -1.3\ntire_radius, left, 229\n";
    let file = corner("hpl_", [1.0; 3]) + numbers;
    for (option, axle) in [("--side=right", "axle"), ("--axle", "right_axle")] {
        let imported = import(folder.path(), "a.csv", &file, &[option]);
        assert_angles(&imported, axle, [0.4, -1.3]);
        let radius = imported.motion["vehicle"]["wheel_radius"].as_float();
        assert_eq!(radius, Some(229.0));
    }
}

#[test]
fn each_side_has_the_angles_stated_for_that_side() {
    let folder = folder();
    let sides = corner("hpl_", [1.0; 3]) + &corner("hpr_", [1.0, -1.0, 1.0]);
    let numbers = "pvl_toe_angle, 0.4\npvr_toe_angle, 0.1\ncamber_angle, -1.3\n";
    let imported = import(folder.path(), "a.csv", &(sides + numbers), &[]);
    assert_angles(&imported, "left_axle", [0.4, -1.3]);
    assert_angles(&imported, "right_axle", [0.1, -1.3]);
}

/// In the axes of the names the corner is on the left; in the stated axes on the right.
#[test]
fn the_side_option_settles_a_conflict_of_names_and_axes() {
    let folder = folder();
    let mirrored = corner("hpl_", [1.0; 3]);
    let options = ["--axes", "iso", "--side", "left"];
    let imported = import(folder.path(), "a.csv", &mirrored, &options);
    let points = imported.points();
    assert_eq!(points["wheel_centre"], [0.0, 610.0, 229.0]);
    assert!(imported.notes.contains(
        "the coordinates are those of the right corner; the left corner is its mirror image, as the options ask"
    ));
}

/// Tables with x rearward, y outboard on the left, and z up or down are of none of the three.
#[test]
fn other_axes_are_refused_with_the_columns_to_change() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", &table(&CORNER), &[]);
    for (signs, columns) in [([1.0, -1.0, 1.0], "x"), ([1.0, -1.0, -1.0], "x and z")] {
        let file = |signs: [f64; 3]| {
            let points =
                CORNER.map(|(name, at)| (name, [0, 1, 2].map(|axis| signs[axis] * at[axis])));
            table(&points).replace("wheel_center", "hpl_wheel_center")
        };
        let said = refusal("a.csv", &file(signs), &[]);
        let expected = format!("; for iso change the signs of {columns}, or exchange");
        assert!(said.contains(&expected), "{said}");
        let in_iso = [-1.0, -1.0, 1.0];
        let imported = import(folder.path(), "a.csv", &file(in_iso), &[]);
        assert_eq!(imported.points(), plain.points());
    }
}
