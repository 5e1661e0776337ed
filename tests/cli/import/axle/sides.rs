//! Sides that are mirror images, and sides that are not.

use super::super::super::program::folder;
use super::super::refused::refusal;
use super::super::{IN_OUR_AXES, import};
use super::{assert_near, side, swept, symmetric};

#[test]
fn sides_that_are_not_mirror_images_are_imported_as_an_axle() {
    let folder = folder();
    let file = symmetric().replace("hpr_lca_outer, -4, 560", "hpr_lca_outer, -4, 557");
    let imported = import(folder.path(), "front.csv", &file, &[]);
    let points = imported.points();
    assert_eq!(points["left_lower_ball"], [4.0, 560.0, 128.0]);
    assert_eq!(points["right_lower_ball"], [4.0, -557.0, 128.0]);
    let expected = "left and right are not mirror images, for example at `hpr_lca_outer` (front.csv:18; y = 557, but -560 on the left): the motion file is \
                    an axle of both corners; --side takes one of them";
    assert!(imported.notes.contains(expected), "{}", imported.notes);
    // A requested side is still imported as a corner.
    let imported = import(folder.path(), "front.csv", &file, &["--side", "right"]);
    assert_eq!(imported.text("linkage"), "double_wishbone_rocker");
    assert_eq!(imported.points()["lower_ball"], [4.0, -557.0, 128.0]);
}

/// With `--axle` too; of several points that with the largest difference is named, as a slip in one digit is.
#[test]
fn the_point_furthest_from_the_mirror_image_is_named() {
    let folder = folder();
    let file = symmetric()
        .replace("hpr_lca_outer, -4, 560", "hpr_lca_outer, -4, 557")
        .replace("hpr_prod_inboard, 10, 265", "hpr_prod_inboard, 10, 26.5");
    let expected = "left and right are not mirror images, for example at `hpr_prod_inboard` (front.csv:26; y = 26.5, but -265 on the left)\n";
    let notes = import(folder.path(), "front.csv", &file, &["--axle"]).notes;
    assert!(notes.contains(expected), "{notes}");
    let notes = import(folder.path(), "front.csv", &symmetric(), &["--axle"]).notes;
    assert!(!notes.contains("mirror images"), "{notes}");
}

/// In tables with y counted outboard on both sides; which side is meant is not guessed.
#[test]
fn an_axle_whose_right_corner_is_on_the_left_by_its_coordinates_is_refused() {
    let columns = |sign: f64| {
        let rows = IN_OUR_AXES.map(|(name, [x, y, z])| {
            format!("{name}; {x}; {y}; {z}; {}; {}; {z}\n", x + 1.0, sign * y)
        });
        format!("Point; Left; ; ; Right; ; \n{}", rows.concat())
    };
    let folder = folder();
    let imported = import(folder.path(), "a.csv", &columns(-1.0), &[]);
    assert_eq!(imported.points()["right_wheel_centre"][1], -610.0);
    for options in [&[][..], &["--axle"]] {
        let said = refusal("a.csv", &columns(1.0), options);
        let expected = "a.csv: `wheel_centre` is on the right by its name, and on the left by y = 610 in axes ISO 8855 (x forward, y \
                        left, z up); change the signs of y at the points of the right corner";
        assert_eq!(said, expected);
    }
}

#[test]
fn of_mirrored_sides_the_left_corner_is_imported_and_axle_noted() {
    let folder = folder();
    let imported = import(folder.path(), "front.csv", &symmetric(), &[]);
    assert_eq!(imported.text("linkage"), "double_wishbone_rocker");
    let expected =
        "the right corner is the mirror image of the left one; --axle makes an axle of both";
    assert!(imported.notes.contains(expected), "{}", imported.notes);
    let imported = import(folder.path(), "front.csv", &side("hpl_", 1.0), &[]);
    assert!(!imported.notes.contains("--axle"), "{}", imported.notes);
}

/// Notes on an axle do not mention a left corner, whether the file has both sides or one.
#[test]
fn notes_on_an_imported_axle_do_not_mention_a_corner() {
    let folder = folder();
    let of_one = "the coordinates are those of the left corner; the right corner is its mirror image, as the options ask";
    for (file, is_one) in [
        (symmetric(), false),
        (side("hpl_", 1.0), true),
        (side("", 1.0), true),
    ] {
        let notes = import(folder.path(), "front.csv", &file, &["--axle"]).notes;
        assert!(!notes.contains("the corner is the"), "{notes}");
        assert_eq!(notes.contains(of_one), is_one, "{notes}");
    }
}

#[test]
fn angles_and_radii_of_each_side_stay_with_that_side() {
    let folder = folder();
    let points = side("hpl_", 1.0) + &side("hpr_", -1.0);
    let file = points
        + "camber_angle, left, -1.0\ncamber_angle, right, -1.5\ntire_radius, left, 229\ntire_radius, right, 231\n";
    let imported = import(folder.path(), "front.csv", &file, &[]);
    assert!(
        imported
            .notes
            .contains("not mirror images, for example at `camber_angle` (front.csv:31)"),
        "{}",
        imported.notes
    );
    let design = &swept(folder.path(), "motion.toml", &["steer=0"])[0];
    assert_near(design["left_camber_deg"], -1.0, "left camber");
    assert_near(design["right_camber_deg"], -1.5, "right camber");
    let radius = imported.motion["vehicle"]["wheel_radius"]
        .as_table()
        .expect("a table");
    let radius = ["left", "right"].map(|side| radius[side].as_float());
    assert_eq!(radius, [Some(229.0), Some(231.0)]);
}

#[test]
fn unused_points_of_an_incomplete_side_are_noted() {
    let folder = folder();
    let file = side("hpl_", 1.0) + "hpr_lca_outer, -4, 557, 128\n";
    let imported = import(folder.path(), "front.csv", &file, &[]);
    assert_eq!(imported.text("linkage"), "double_wishbone_rocker");
    let expected = "the file has points of the other side too, but not all: they are not used";
    assert!(imported.notes.contains(expected), "{}", imported.notes);
}
