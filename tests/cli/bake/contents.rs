//! Descriptions in baked files, and the baked file of the firmware.

use std::path::Path;

use super::super::program::{example, folder, run};
use super::{RANGE, baked, baked_of};

/// Names in a baked file are valid identifiers for any file name.
#[test]
fn names_in_a_baked_file_are_valid_identifiers_of_its_file_name() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    for (path, name) in [
        ("wheel_by_theta.toml", "wheel_by_theta"),
        ("out/rear left.toml", "rear_left_wheel_by_theta"),
        ("911.toml", "baked_911_wheel_by_theta"),
        ("\u{fc}ber.toml", "baked__ber_wheel_by_theta"),
        ("int.toml", "int_wheel_by_theta"),
    ] {
        let arguments = ["bake", "a.toml", "--as", "toml", "--out", path];
        let output = run(folder.path(), &[&arguments[..], &RANGE].concat());
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let text = std::fs::read_to_string(folder.path().join(path)).expect("a file");
        let table: toml::Table = text.parse().expect("TOML");
        assert_eq!(table["name"].as_str(), Some(name));
    }
}

#[test]
fn a_baked_header_states_its_range_to_the_last_digit() {
    let range = ["--from", "0.7500000000000001", "--to", "1.0123456789012344"];
    let file = baked(folder().path(), &range);
    let expected = "// Drive: theta from 0.7500000000000001 to 1.0123456789012344 rad.";
    assert!(file.contains(expected), "{}", &file[..400]);
}

#[test]
fn a_baked_header_states_points_range_units_and_tolerance() {
    let folder = folder();
    let arguments = [
        "--tolerance",
        "1e-5",
        "--continuity",
        "2",
        "--points",
        "all",
    ];
    let file = baked(folder.path(), &[&RANGE[..], &arguments].concat());
    for line in [
        "// The 6 points of five_link as a function of drive theta.",
        "// Baked by `suspension bake` from a.toml.",
        "// Drive: theta from 0.75 to 2 rad.",
        "// Lengths in mm; axes x forward, y left, z up.",
        "// Continuous where segments join: position, first and second derivative.",
        "// Tolerance asked: 0.01 mm; reached: 0.00",
    ] {
        assert!(file.contains(line), "{line}\n{}", &file[..900]);
    }
    let segments = file.matches("    [\n").count();
    let bytes = segments * 6 * 18 * 8;
    assert!(file.contains(&format!(
        "// {segments} segments of degree 5, {bytes} bytes."
    )));
}

/// Only the wheel has a spin axis.
#[test]
fn a_header_of_baked_points_does_not_mention_a_spin_axis() {
    let folder = folder();
    let expected = "// The spin axis counts as a point 1 m from the wheel centre.\n";
    for (points, is_mentioned) in [("wheel", true), ("all", false)] {
        let file = baked(folder.path(), &[&RANGE[..], &["--points", points]].concat());
        assert_eq!(file.contains(expected), is_mentioned, "{}", &file[..900]);
        assert_eq!(file.contains("spin axis"), is_mentioned);
    }
}

#[test]
fn a_baked_header_names_the_wheel_of_an_axle() {
    let range = ["--drive", "bump_left=0.28:0.34"];
    let file = baked_of("live_axle_panhard.toml", folder().path(), &range);
    let expected = "// The left wheel centre and spin axis (unit length, outboard) of live_axle_panhard as a function of";
    assert!(file.contains(expected), "{}", &file[..400]);
}

/// The baked file of the firmware is written by the program, not by hand.
#[test]
fn the_baked_file_of_the_firmware_is_up_to_date() {
    let folder = folder();
    std::fs::write(
        folder.path().join("attia2003.toml"),
        example("attia2003.toml"),
    )
    .expect("written");
    let arguments = ["bake", "attia2003.toml", "--out", "wheel_by_theta.rs"];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let [baked, kept] = [
        folder.path().join("wheel_by_theta.rs"),
        Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("tests/firmware/controller/src/wheel_by_theta.rs"),
    ]
    .map(|path| std::fs::read_to_string(path).expect("a source file"));
    // They differ only in the path of the motion file.
    assert_eq!(
        baked,
        kept.replace("examples/attia2003.toml", "attia2003.toml")
    );
}
