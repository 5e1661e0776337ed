//! Files with a line for each coordinate of a point: assignments, parameters of a spreadsheet, YAML and JSON.

use super::super::program::folder;
use super::refused::refusal;
use super::{CORNER, import, table};

/// Writes the points of the corner, each with three lines under their axes.
fn lines(line: impl Fn(&str, &str, f64) -> String) -> String {
    let of_point = |(name, at): &(&str, [f64; 3])| {
        let axes = ["x", "y", "z"].into_iter().zip(*at);
        axes.map(|(axis, value)| line(name, axis, value))
            .collect::<String>()
    };
    CORNER.iter().map(of_point).collect()
}

/// Writes the points as a name above its coordinates.
fn below(line: impl Fn(&str, [f64; 3]) -> String) -> String {
    CORNER.iter().map(|(name, at)| line(name, *at)).collect()
}

#[test]
fn a_line_for_each_coordinate_imports_the_same_points() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", &table(&CORNER), &[]);
    for file in [
        lines(|name, axis, value| format!("{name}_{axis} = {value}; % hardpoint\n")),
        lines(|name, axis, value| format!("  {name}.{axis}  {value}\n")),
        lines(|name, axis, value| format!("{name} {} [mm];{value},0\n", axis.to_uppercase())),
        "name,value,unit\n".to_owned()
            + &lines(|name, axis, value| format!("{name} {axis},{value},mm\n")),
        below(|name, [x, y, z]| format!("{name}:\n  x: {x}\n  y: {y}\n  z: {z}\n")),
        below(|name, [x, y, z]| format!("- name: {name}\n  x: {x} # mm\n  y: {y}\n  z: {z}\n")),
        below(|name, [x, y, z]| {
            format!("  \"{name}\": {{\n    \"x\": {x},\n    \"y\": {y},\n    \"z\": {z}\n  }},\n")
        }),
    ] {
        let imported = import(folder.path(), "a.txt", &file, &[]);
        assert_eq!(imported.points(), plain.points(), "{file}");
        assert!(imported.notes.contains("lengths is mm"), "{file}");
    }
}

/// Dashes and blanks that word processors put in.
#[test]
fn signs_beyond_ascii_separate_the_words_of_names() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", &table(&CORNER), &[]);
    for sign in ["\u{2013}", "\u{2212}", "\u{a0}", " \u{b0} "] {
        let file = table(&CORNER).replace('_', sign);
        let file = file + &format!("tire{sign}radius, 229\n");
        let imported = import(folder.path(), "a.csv", &file, &[]);
        assert_eq!(imported.points(), plain.points(), "{file}");
        let radius = imported.motion["vehicle"]["wheel_radius"].as_float();
        assert_eq!(radius, Some(229.0), "{file}");
    }
}

#[test]
fn coordinates_without_their_point_or_order_are_no_point() {
    let file = lines(|name, axis, value| format!("{name}_{axis} = {value}\n"));
    for (part, other) in [
        ("lca_rear_y = -175\n", ""),
        ("lca_rear_y", "lca_rear_z"),
        ("lca_rear_y = -175", "lca_raer_y = -175"),
        ("lca_rear_y = -175", "lca_rear_y = -l75"),
    ] {
        assert!(file.contains(part));
        let said = refusal("a.m", &file.replace(part, other), &[]);
        let expected = "`lower_rear`";
        assert!(said.contains(expected), "{other}: {said}");
    }
}

/// The number behind a comma may be decimals, or a tolerance.
#[test]
fn a_second_number_between_commas_is_not_read_as_decimals() {
    let file = lines(|name, axis, value| format!("{name} {axis},{value},2\n"));
    let said = refusal("a.csv", &file, &[]);
    let expected = "a.csv:1:1: point `lca_front` needs three numbers in a row";
    assert!(said.starts_with(expected), "{said}");
}

#[test]
fn inches_behind_coordinates_are_the_unit() {
    let folder = folder();
    let file = lines(|name, axis, value| format!("{name}_{axis}, {}, in\n", value / 25.4));
    let imported = import(folder.path(), "a.csv", &file, &[]);
    assert_eq!(imported.text("unit"), "in");
}
