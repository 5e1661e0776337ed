//! Axes and sides.

use std::collections::BTreeMap;

use super::super::program::folder;
use super::{CORNER, IN_OUR_AXES, import, listed, table};

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
fn axes_are_told_by_the_order_of_points_and_named() {
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
        let told = format!("note: a.csv: axes are {axes}");
        assert!(imported.notes.contains(&told), "{}", imported.notes);
    }
}

/// A published layout has the same names, and its front links behind the rear ones.
#[test]
fn axes_of_five_links_are_told() {
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
        let told = format!("note: a.csv: axes are {axes} (");
        assert!(imported.notes.contains(&told), "{}", imported.notes);
    }
}

#[test]
fn axes_that_are_stated_are_taken_and_doubted_where_points_speak_against_them() {
    let folder = folder();
    let imported = import(
        folder.path(),
        "a.csv",
        &corner("", [1.0; 3]),
        &["--axes", "iso"],
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
fn a_corner_stays_on_its_side_unless_the_other_is_wanted() {
    let folder = folder();
    let right = [1.0, -1.0, 1.0];
    for (file, options, y, said) in [
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
            "by its coordinates the file has the right corner; the left one is its mirror image, as the options ask for",
        ),
        (
            corner("hpl_", [1.0; 3]),
            vec!["--side", "right"],
            -1.0,
            "by its coordinates the file has the left corner; the right one is its mirror image, as the options ask for",
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
        assert_eq!(imported.points(), expected(y), "{said}");
        assert!(imported.notes.contains(said), "{}", imported.notes);
        let axle = imported.motion["points"]["axle"]["offset"][1].as_float();
        assert_eq!(axle, Some(-100.0 * y));
    }
}

/// In the names' axes the corner is on the left; in those that are stated on the right.
#[test]
fn a_side_that_names_and_axes_do_not_share_is_settled_by_the_user() {
    let folder = folder();
    let mirrored = corner("hpl_", [1.0; 3]);
    let options = ["--axes", "iso", "--side", "left"];
    let imported = import(folder.path(), "a.csv", &mirrored, &options);
    let points = imported.points();
    assert_eq!(points["wheel_centre"], [0.0, 610.0, 229.0]);
    assert!(imported.notes.contains(
        "by its coordinates the file has the right corner; the left one is its mirror image, as the options ask for"
    ));
}
