//! Markers that the file states relative to a point, as `import` writes those of the spin axis.

use std::path::Path;

use super::super::program::{folder, rows, run};
use super::{DRIVES, file, met, swept, target};

/// Imports the hardpoints of the examples as `a.toml`, and adds lines on tuning.
fn imported(folder: &Path, options: &[&str], tune: &str) {
    let hardpoints = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/hardpoints.csv");
    let import = ["import", hardpoints, "--out", "a.toml"];
    let output = run(folder, &[&import, options].concat());
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let path = folder.join("a.toml");
    let text = std::fs::read_to_string(&path).expect("a file");
    std::fs::write(path, text + tune).expect("written");
}

/// The toe of a wheel at the design position, in degrees.
fn toe(folder: &Path, wheel: &str) -> f64 {
    let sweep = ["sweep", "a_tuned.toml", "--drive", "steer=0", "--csv", "-"];
    let output = run(folder, &sweep);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    rows(&output.stdout)[0][wheel]
}

/// The tie rod turns the upright, and with it the marker, away from its stated offset.
#[test]
fn a_turnbuckle_of_an_imported_corner_changes_the_offset_of_the_spin_axis() {
    let folder = folder();
    let tune = "[tune.moves.turnbuckle]\nlength = \"tie_rod\"\nby = [-5.0, 5.0]\n";
    imported(
        folder.path(),
        &[],
        &format!("{tune}{}", target("toe", 0.0, 1e-4)),
    );
    let output = run(folder.path(), &["tune", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let written = std::fs::read_to_string(folder.path().join("a_tuned.toml")).expect("a file");
    assert!(
        written.contains("\naxle = { from = \"wheel_centre\", offset = ["),
        "{written}"
    );
    let toe = toe(folder.path(), "toe_deg");
    assert!(toe.abs() <= 1e-4, "{toe}");
}

#[test]
fn turnbuckles_of_an_imported_axle_keep_it_symmetric() {
    let folder = folder();
    let tune = "[tune.moves.turnbuckle]\nlength = \"left_tie_rod\"\nmirrored = [\"right_tie_rod\"]\nby = [-5.0, 5.0]\n";
    imported(
        folder.path(),
        &["--axle"],
        &format!("{tune}{}", target("left_toe", 0.0, 1e-4)),
    );
    let output = run(folder.path(), &["tune", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    for wheel in ["left_toe_deg", "right_toe_deg"] {
        let toe = toe(folder.path(), wheel);
        assert!(toe.abs() <= 1e-4, "{wheel}: {toe}");
    }
}

/// Each form of TOML in which an offset may be stated, and the marker itself as the point that is moved.
#[test]
fn a_moved_marker_keeps_the_form_in_which_it_is_stated() {
    let tune = "[tune.moves.marker]\npoints = [\"axle\"]\nalong = \"x\"\nby = [-0.01, 0.01]\n";
    let tune = tune.to_owned() + &target("toe", 0.5, 1e-4);
    for [before, offset] in [
        [
            "[points]\naxle = { from = \"wheel_centre\", offset = ",
            " } # inboard\n",
        ],
        [
            "[points.axle]\nfrom = \"wheel_centre\"\noffset = ",
            " # inboard\n",
        ],
        [
            "[points]\naxle.offset = ",
            "\naxle.from = \"wheel_centre\"\n",
        ],
    ] {
        let folder = folder();
        let marker = format!("{before}[0.0, -0.1, 0.0]{offset}");
        met(
            folder.path(),
            &file("double_wishbone", DRIVES, &format!("{marker}{tune}")),
        );
        let written = std::fs::read_to_string(folder.path().join("a_tuned.toml")).expect("a file");
        let (_, rest) = written.split_once(before).expect(&written);
        let (numbers, rest) = rest.split_once(']').expect("a list");
        let offset = offset.replace('#', "# moved by tune from [0.0, -0.1, 0.0];");
        assert!(rest.starts_with(&offset), "{written}");
        assert!(
            numbers.starts_with("[0.0008") || numbers.starts_with("[-0.0008"),
            "{written}"
        );
        let toe = swept(folder.path())[24]["toe_deg"];
        assert!((toe - 0.5).abs() <= 1e-4, "{toe}");
    }
}
