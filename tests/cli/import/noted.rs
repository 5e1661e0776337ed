//! Notes on hardpoints that may be mistakes.

use super::super::program::folder;
use super::refused::refusal;
use super::{CORNER, import, table};

#[test]
fn a_point_on_the_other_side_of_the_vehicle_is_noted() {
    let folder = folder();
    let doubt = "is on the other side of the vehicle than";
    let turned = table(&CORNER).replace("lca_outer, -4, -560", "lca_outer, -4, 560");
    let imported = import(folder.path(), "a.csv", &turned, &[]);
    let expected = format!(
        "motion.toml: `lower_ball` (lca_outer, a.csv:3) {doubt} `wheel_centre` (wheel_center, a.csv:9): is the sign of its y right?"
    );
    assert!(imported.notes.contains(&expected), "{}", imported.notes);
    assert_eq!(imported.notes.matches(doubt).count(), 1);
    // A chassis point may be a little beyond the middle.
    let damper = table(&CORNER).replace("4, -20, 530", "4, 20, 530");
    for file in [table(&CORNER), damper] {
        let imported = import(folder.path(), "a.csv", &file, &[]);
        assert!(!imported.notes.contains(doubt), "{}", imported.notes);
    }
}

/// The mistake is the wheel centre's alone: to change the signs of a whole column would be wrong.
#[test]
fn a_wheel_centre_alone_on_its_side_is_refused() {
    for options in [&[][..], &["--axes", "adams"]] {
        // A point in the middle of the vehicle, as that of a bar, is on neither side.
        let turned = table(&CORNER)
            .replace("-610", "610")
            .replace("4, -20, 530", "4, 0, 530");
        let message = refusal("a.csv", &turned, options);
        assert_eq!(
            message,
            "a.csv: y is 610 at `wheel_center` and -170 at `lca_front`, and all points but the wheel centre are on that side of the \
             vehicle: is the sign of y at `wheel_center` right?"
        );
    }
}

#[test]
fn an_inner_end_outboard_of_its_outer_end_is_noted() {
    let folder = folder();
    let doubt = "is further from the middle of the vehicle than";
    for [inner, outer] in [
        ["tierod_inner", "tierod_outer"],
        ["prod_inboard", "prod_outboard"],
    ] {
        let swapped = table(&CORNER).replace(inner, "other");
        let swapped = swapped.replace(outer, inner).replace("other", outer);
        for options in [&[][..], &["--axle"]] {
            let notes = import(folder.path(), "a.csv", &swapped, options).notes;
            let lines: Vec<&str> = notes.lines().filter(|line| line.contains(doubt)).collect();
            let [line] = lines[..] else {
                panic!("one note of {inner}: {notes}");
            };
            assert!(
                line.starts_with(&format!("note: a.csv: `{inner}` (a.csv:")),
                "{line}"
            );
            assert!(
                line.contains(&format!("{doubt} `{outer}` (a.csv:")),
                "{line}"
            );
            assert!(line.ends_with("): have they each other's names?"), "{line}");
        }
    }
    let notes = import(folder.path(), "a.csv", &table(&CORNER), &[]).notes;
    assert!(!notes.contains(doubt), "{notes}");
}

#[test]
fn a_slipped_decimal_point_is_noted() {
    let folder = folder();
    for (written, slipped, expected) in [
        (
            "tierod_inner, -72",
            "tierod_inner, -1200",
            "`rack` (tierod_inner, a.csv:7) lies 1061 mm from the other points: should its x be 120 instead of 1200?",
        ),
        (
            "4, -20, 530",
            "4, -20, 1582",
            "`damper_inner` (shock_to_chassis, a.csv:15) lies 1084 mm from the other points: should its z be 158.2 instead of 1582?",
        ),
    ] {
        let file = table(&CORNER);
        assert!(file.contains(written), "{file}");
        let notes = import(folder.path(), "a.csv", &file.replace(written, slipped), &[]).notes;
        assert!(notes.contains(expected), "{notes}");
        let notes = import(folder.path(), "a.csv", &file, &[]).notes;
        assert!(!notes.contains("from the other points"), "{notes}");
    }
}

#[test]
fn a_wheel_radius_that_seems_to_be_the_diameter_is_noted() {
    let folder = folder();
    let diameter = "is it the diameter?";
    let slipped = "are its decimal point and unit right?";
    for (radius, doubt) in [
        (229, None),
        (340, None),
        (440, Some(diameter)),
        (465, Some(diameter)),
        (1200, Some(slipped)),
        (2290, Some(slipped)),
    ] {
        let file = format!("{}tire_radius, {radius}\n", table(&CORNER));
        let notes = import(folder.path(), "a.csv", &file, &[]).notes;
        let mut notes = notes.lines();
        let noted = notes.find(|note| note.contains("wheel_radius is"));
        let expected = doubt.map(|doubt| {
            format!(
                "note: motion.toml: wheel_radius is {radius} mm, and `wheel_centre` (wheel_center, a.csv:9) is at y = 610 and z = 229: {doubt}"
            )
        });
        assert_eq!(noted, expected.as_deref());
    }
}

#[test]
fn a_point_below_the_ground_is_noted() {
    let folder = folder();
    let file = table(&CORNER) + "tire_radius, 229\n";
    for (z, expected) in [
        ("152", None),
        ("-20", None),
        (
            "-152",
            Some(
                "note: motion.toml: `rack` (tierod_inner, a.csv:7) lies 152 mm below the ground, which is wheel_radius below `wheel_centre` (wheel_center, a.csv:9): are the z of both right?",
            ),
        ),
    ] {
        assert!(file.contains("-190, 152"), "{file}");
        let file = file.replace("-190, 152", &format!("-190, {z}"));
        let notes = import(folder.path(), "a.csv", &file, &[]).notes;
        let noted = notes.lines().find(|note| note.contains("below the ground"));
        assert_eq!(noted, expected, "{notes}");
    }
}

#[test]
fn a_wheel_below_all_other_points_is_noted() {
    let folder = folder();
    let file = table(&CORNER) + "tire_radius, 229\n";
    for (z, expected) in [
        ("-90", None),
        (
            "-229",
            Some(
                "note: motion.toml: `wheel_centre` (wheel_center, a.csv:9) lies 349 mm below all other points, which is more than wheel_radius: is its z right?",
            ),
        ),
    ] {
        assert!(file.contains("-610, 229"), "{file}");
        let file = file.replace("-610, 229", &format!("-610, {z}"));
        let notes = import(folder.path(), "a.csv", &file, &[]).notes;
        let noted = notes
            .lines()
            .find(|note| note.contains("below all other points"));
        assert_eq!(noted, expected, "{notes}");
    }
}

/// As points of unknown names are.
#[test]
fn rows_of_numbers_with_unknown_names_are_listed() {
    let folder = folder();
    let rows =
        "Reifenhalbmesser; 310\nfoo radius, 12 mm\nstops, 1, 2\nseen by Smith in 2024, a Monday\n";
    let imported = import(folder.path(), "a.csv", &(table(&CORNER) + rows), &[]);
    let expected = "note: a.csv: numbers that are not used: `Reifenhalbmesser` (a.csv:16), `foo radius` (a.csv:17), `stops` (a.csv:18)\n";
    assert!(imported.notes.contains(expected), "{}", imported.notes);
    let many: String = (0..100).map(|row| format!("foo {row}, 1\n")).collect();
    let imported = import(folder.path(), "a.csv", &(table(&CORNER) + &many), &[]);
    let expected = "`foo 39` (a.csv:55), and 60 more\n";
    assert!(imported.notes.contains(expected), "{}", imported.notes);
}

/// Corners of the catalogue are left ones; the imported one may be either.
#[test]
fn the_note_on_the_layout_does_not_name_a_side() {
    let folder = folder();
    let imported = import(
        folder.path(),
        "a.csv",
        &table(&CORNER),
        &["--side", "right"],
    );
    let expected = "A double wishbone with a steering rack, a pushrod from the lower wishbone to a rocker, and a damper.\n";
    assert!(imported.notes.contains(expected), "{}", imported.notes);
}

/// The rates of the drives are in no file of hardpoints.
#[test]
fn a_note_calls_the_imported_motion_an_example() {
    let folder = folder();
    let imported = import(folder.path(), "a.csv", &table(&CORNER), &[]);
    let expected = "the motion is an example: for one second bump grows by 30 mm a second, other drives are held\n";
    assert!(imported.notes.contains(expected), "{}", imported.notes);
}
