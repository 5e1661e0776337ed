//! Tables with a column for each point.

use super::super::program::folder;
use super::refused::refusal;
use super::{CORNER, import, table};

/// A line with a cell for each point.
fn line(label: &str, separator: &str, cell: impl Fn(&str, [f64; 3]) -> String) -> String {
    let cells = CORNER.map(|(name, at)| cell(name, at));
    format!("{label}{separator}{}\n", cells.join(separator))
}

fn block(labels: [&str; 4], separator: &str, sign: f64) -> [String; 4] {
    let [names, axes @ ..] = labels;
    let [x, y, z] = axes.map(|axis| {
        let index = ["x", "y", "z"]
            .iter()
            .position(|name| axis.to_lowercase().contains(name));
        line(axis, separator, |_, [x, y, z]| {
            let at = [x, sign * y, z][index.expect("an axis")];
            format!("{at:.1}").replace('.', if separator == "," { "." } else { "," })
        })
    });
    [line(names, separator, |name, _| name.to_owned()), x, y, z]
}

#[test]
fn names_may_be_the_headings_of_columns() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", &table(&CORNER), &[]);
    for (labels, separator) in [
        (["", "X", "Y", "Z"], ";"),
        (["Coordinate [mm]", "x", "y", "z"], ","),
        (["", "X [mm]", "Y [mm]", "Z [mm]"], "\t"),
        (["\"Axis\"", "\"x\"", "\"y\"", "\"z\""], ";"),
    ] {
        let file = block(labels, separator, 1.0).concat();
        let imported = import(folder.path(), "a.csv", &format!("Hardpoints\n{file}"), &[]);
        assert_eq!(imported.points(), plain.points(), "{labels:?}");
        let says_unit = labels.concat().contains("mm");
        assert_eq!(
            imported.notes.contains("mm, as the file says"),
            says_unit,
            "{labels:?}"
        );
    }
}

/// The names stand once above the lines of both corners.
#[test]
fn labels_of_lines_may_state_the_corner() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", &table(&CORNER), &["--side", "left"]);
    let [names, x, y, z] = block(["", "FL x", "FL y", "FL z"], ";", 1.0);
    let [_, right @ ..] = block(["", "FR x", "FR y", "FR z"], ";", -1.0);
    let file = format!("{names}{x}{y}{z}{}", right.concat());
    let imported = import(folder.path(), "a.csv", &file, &[]);
    assert_eq!(imported.points(), plain.points());
    let said = "the right corner is the mirror image of the left one";
    assert!(imported.notes.contains(said), "{}", imported.notes);
}

#[test]
fn a_missing_coordinate_of_a_column_is_refused_at_its_column() {
    let file = block(["", "X", "Y", "Z"], ";", 1.0).concat();
    let said = refusal("a.csv", &file.replace(";-190,0;", ";;"), &[]);
    assert_eq!(
        said,
        "a.csv:2:39: a cell between the numbers is empty: write the coordinate there, or take the empty column out of the table"
    );
}

/// The place is behind the end of the line.
#[test]
fn a_line_with_fewer_cells_than_names_lacks_coordinates() {
    let file = block(["", "X", "Y", "Z"], ";", 1.0).concat();
    let said = refusal("a.csv", &file.replace(";6,0;4,0\n", "\n"), &[]);
    assert!(said.starts_with("a.csv:2:"), "{said}");
    assert!(said.contains("`shock_to_bellcrank"), "{said}");
}

/// A line for each coordinate, with a column for each corner.
#[test]
fn columns_may_be_those_of_corners_beside_a_line_for_each_coordinate() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", &table(&CORNER), &["--side", "left"]);
    let rows = CORNER.map(|(name, [x, y, z])| {
        let right = -y;
        format!("{name};X;{x};{x}\n{name};Y;{y};{right}\n{name};Z;{z};{z}\n")
    });
    let file = format!("Point;Axis;FL;FR\n{}", rows.concat());
    let imported = import(folder.path(), "a.csv", &file, &[]);
    assert_eq!(imported.points(), plain.points());
    let said = "the right corner is the mirror image of the left one";
    assert!(imported.notes.contains(said), "{}", imported.notes);
}

#[test]
fn limits_of_coordinates_are_no_points() {
    let rows = CORNER.map(|(name, at)| {
        let of = |(axis, x)| format!("{name} {axis};{x};{};{}\n", x - 5.0, x + 5.0);
        ["X", "Y", "Z"]
            .into_iter()
            .zip(at)
            .map(of)
            .collect::<String>()
    });
    let file = format!("Parameter;Value;Min;Max\n{}", rows.concat());
    let said = refusal("a.csv", &file, &[]);
    assert!(!said.contains("Value"), "{said}");
    assert!(said.contains("`lca_front X`"), "{said}");
}
