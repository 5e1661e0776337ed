//! The same corner in each format.

use std::fmt::Write;

use super::super::program::{folder, run};
use super::{CORNER, IN_OUR_AXES, import, table};

/// Returns a subsystem file of Adams/Car in a unit of which `millimetre` is one millimetre.
fn subsystem(unit: &str, millimetre: f64) -> String {
    let mut file =
        "$---MDI_HEADER\n[MDI_HEADER]\n FILE_TYPE = 'sub'\n FILE_VERSION = 4.0\n".to_owned();
    write!(file, "[UNITS]\n LENGTH = '{unit}'\n ANGLE = 'radians'\n").unwrap();
    file += "[HARDPOINT]\n{hardpoint_name symmetry x_value y_value z_value}\n";
    file += " 'global              '  'single    '  0.0  0.0  0.0\n";
    for (name, at) in CORNER {
        let [x, y, z] = at.map(|x| x * millimetre);
        writeln!(file, " '{name:20}'  'left/right'  {x}  {y}  {z}").unwrap();
    }
    file += "[PARAMETER]\n{parameter_name symmetry type value}\n";
    file += " 'camber_angle '  'left/right'  'real'  -0.02\n 'kinematic_flag '  'single '  'integer'  0\n";
    file + "[BUSHING]\n 'lca_front'  1.0  2.0  3.0\n"
}

/// A model file of Lotus, with two points that are no hardpoints among the others.
fn model() -> String {
    let mut points: Vec<(String, [f64; 3])> =
        CORNER.map(|(name, at)| (name.replace('_', " "), at)).into();
    points.push(("Part 1 C of G".to_owned(), [1.0, 2.0, 3.0]));
    points.push(("Part 2 C of G".to_owned(), [3.0, 2.0, 1.0]));
    let mut file =
        "VERSION\n  15  3\n  1\nTEMP_SETTINGS\n  14\nDouble Wishbone, Push Rod to damper\n"
            .to_owned();
    writeln!(
        file,
        "  2  {}  12  16  3\nLower Wishbone\nUpright",
        points.len()
    )
    .unwrap();
    for (name, _) in &points {
        let described = "Not Defined\n".repeat(5);
        let ends = "  1  0  1  -1  1  0  0  0  0\n  0  0  0  0  0  0  0";
        writeln!(file, "{name}\n{described}  9.0  9.0  9.0\n{ends}").unwrap();
    }
    file += "EXTENDED_TYRE\n  0  0\nFRONT SUSPENSION\n  14\n";
    for (_, [x, y, z]) in &points {
        writeln!(file, "  {x:.10}  {y:.10}  {z:.10}").unwrap();
    }
    file + "  229.5\nTOLERANCES\n  1.0E-10  5.0E-02  5.0E-02\n"
}

#[test]
fn all_hardpoint_formats_import_the_same_points() {
    let with_blanks = CORNER.map(|(name, [x, y, z])| format!("  {name}   {x}  {y} {z}  # bush\n"));
    let german = CORNER.map(|(name, [x, y, z])| format!("\"{name}\";{x},0;{y},000;{z},0;bush\n"));
    let assigned = CORNER.map(|(name, [x, y, z])| format!("{name} = [{x}, {y}, {z}];\n"));
    let mixed = CORNER.map(|(name, [x, y, z])| format!("{name} {x}, {y}, {z}\n"));
    let numbered = CORNER.map(|(name, [x, y, z])| format!("{x}\t{y}\t{z}\tPOINT ( 3 ) = {name}\n"));
    let of_model =
        CORNER.map(|(name, [x, y, z])| format!(".car.susp.ground.hpl_{name} {x} {y} {z}\n"));
    let files = [
        ("a.csv", table(&CORNER)),
        (
            "a.csv",
            format!(
                "Front, rev 3\n\nname, x [mm], y [mm], z [mm]\n{}",
                table(&CORNER)
            ),
        ),
        ("a.txt", with_blanks.concat()),
        ("a.csv", german.concat()),
        ("a.csv", mixed.concat()),
        ("a.csv", table(&CORNER).replace('\n', "\r")),
        ("a.m", assigned.concat()),
        ("a.txt", numbered.concat()),
        ("a.lst", of_model.concat()),
        ("a.sub", subsystem("mm", 1.0)),
        ("a.shk", model()),
    ];
    let folder = folder();
    for (name, file) in files {
        let imported = import(folder.path(), name, &file, &[]);
        assert_eq!(imported.text("linkage"), "double_wishbone_rocker");
        assert_eq!(imported.text("unit"), "mm");
        let expected = IN_OUR_AXES.map(|(name, at)| (name.to_owned(), at));
        assert_eq!(imported.points(), expected.into(), "{file}");
    }
}

/// The axle point is marked relative to the wheel centre, along the spin axis; without toe and camber along y.
#[test]
fn toe_camber_and_radius_are_imported_from_formats_that_have_them() {
    let folder = folder();
    let offset = |name: &str, file: &str| {
        let imported = import(folder.path(), name, file, &[]);
        let axle = imported.motion["points"]["axle"]["offset"].as_array();
        let axle: Vec<f64> = axle
            .expect("three")
            .iter()
            .filter_map(toml::Value::as_float)
            .collect();
        let radius = imported.motion["vehicle"].get("wheel_radius").cloned();
        (axle, radius.and_then(|radius| radius.as_float()))
    };
    let (axle, radius) = offset("a.csv", &table(&CORNER));
    assert_eq!((axle, radius), (vec![0.0, -100.0, 0.0], None));
    let file = subsystem("mm", 1.0);
    let remarked = file.replace("[PARAMETER]", "[PARAMETER]   $ as measured");
    let small = file.replace("[PARAMETER]", "[ parameter ]");
    for file in [file.to_uppercase(), file, remarked, small] {
        let (axle, _) = offset("a.sub", &file);
        assert!(
            (axle[2] / -axle[1] - -0.02_f64.tan()).abs() < 1e-15,
            "{axle:?}"
        );
    }
    let (_, radius) = offset("a.shk", &model());
    assert_eq!(radius, Some(229.5));
    let file = table(&CORNER) + "TYRE ROLLING RADIUS (mm): 229\ntoe [deg], 1.0\n";
    let (axle, radius) = offset("a.csv", &file);
    assert!(
        (axle[0] / axle[1] - 1_f64.to_radians().tan()).abs() < 1e-15,
        "{axle:?}"
    );
    assert_eq!(radius, Some(229.0));
}

#[test]
fn the_unit_of_lengths_is_stated_or_inferred_from_their_size() {
    let folder = folder();
    let found = |file: &str, options: &[&str]| {
        let imported = import(folder.path(), "a.sub", file, options);
        let why = imported
            .notes
            .lines()
            .find(|note| note.contains("the unit of lengths is"));
        (
            imported.text("unit").to_owned(),
            why.expect("a note").to_owned(),
        )
    };
    let inches = 1.0 / 25.4;
    for (unit, millimetre, expected) in [("meter", 1e-3, "m"), ("inch", inches, "in")] {
        let (unit, why) = found(&subsystem(unit, millimetre), &[]);
        assert_eq!(unit, expected);
        assert!(why.ends_with("as the file says"), "{why}");
    }
    for (millimetre, expected) in [(1.0, "mm"), (1e-3, "m"), (inches, "in")] {
        let points = CORNER.map(|(name, at)| (name, at.map(|x| x * millimetre)));
        let (unit, why) = found(&table(&points), &[]);
        assert_eq!(unit, expected);
        let apart = 590.0 * millimetre;
        let expected_text = format!("as the points are up to {}", &apart.to_string()[..3]);
        assert!(why.contains(&expected_text), "{why}");
    }
    let (unit, why) = found(&table(&CORNER), &["--unit", "in"]);
    assert_eq!(unit, "in");
    assert!(why.contains("as --unit says; that is doubtful"), "{why}");
}

#[test]
fn a_table_in_utf_16_is_read() {
    let file = format!("\u{feff}{}", table(&CORNER).replace(", ", "\t"));
    reads_as_in_utf_8(
        &file
            .encode_utf16()
            .flat_map(u16::to_le_bytes)
            .collect::<Vec<u8>>(),
    );
}

/// A spreadsheet program in western Europe saves it so; a minus is typeset as a dash.
#[test]
fn a_table_in_windows_1252_is_read() {
    let numbers = table(&CORNER).replace(", -", ", \u{2013}");
    assert!(numbers.contains('\u{2013}'));
    let file = format!("# Stra\u{df}e, 20 \u{b0}C\n{numbers}");
    let byte = |c: char| match c {
        '\u{2013}' => 0x96,
        _ => u8::try_from(c).expect("a character of Latin-1"),
    };
    reads_as_in_utf_8(&file.chars().map(byte).collect::<Vec<u8>>());
}

/// Imports a corner from a file in another encoding, and the same in UTF-8.
fn reads_as_in_utf_8(encoded: &[u8]) {
    let folder = folder();
    std::fs::write(folder.path().join("a.txt"), encoded).expect("written");
    let output = run(folder.path(), &["import", "a.txt", "--out", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let other = std::fs::read_to_string(folder.path().join("a.toml")).expect("a motion file");
    let other: toml::Table = other.parse().expect("TOML");
    let plain = import(folder.path(), "b.csv", &table(&CORNER), &[]);
    assert_eq!(other, plain.motion);
}
