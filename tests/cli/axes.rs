//! The axes that a motion file may have.

mod compared;
mod downwards;

use std::f64::consts::PI;
use std::fmt::Write;

use suspension_core::linkages::LISTINGS;
use suspension_core::listing::{Part, Parts};
use suspension_runtime::Listing;

use super::program::{Rows, folder, run, table_in, text};

/// The factors of x, y and z, by the name of the axes.
const AXES: [(&str, [f64; 3]); 3] = [
    ("ISO 8855", [1.0, 1.0, 1.0]),
    ("Adams", [-1.0, -1.0, 1.0]),
    ("SAE", [1.0, -1.0, -1.0]),
];

/// An angle from the z axis of the file, measured by the user's own listing.
const LEAN: &str = "lean";

/// The file that states the hardpoints.
#[derive(Clone, Copy, Debug)]
enum Stated {
    /// Only the catalogue.
    Catalogue,
    /// The motion file, with a marker relative to another point.
    File,
    /// The user's own listing.
    Listing,
}

fn corner() -> &'static str {
    let mut texts = LISTINGS.iter();
    let found = texts.find(|(name, _)| *name == "double_wishbone_pushrod");
    found.expect("a text").1
}

fn vector(at: [f64; 3], signs: [f64; 3]) -> String {
    format!("{:?}", [0, 1, 2].map(|axis| at[axis] * signs[axis]))
}

/// Arms that are not parallel in the side view: the instant centre there is not far away.
const UPPER_REAR: [f64; 3] = [-0.15, 0.42, 0.36];

/// The points under their names in the motion file.
fn points(signs: [f64; 3]) -> String {
    let listing = Listing::parse(corner()).expect("a listing");
    let mut points = String::new();
    for (point, at) in listing.stated() {
        let name = listing.name(Part::Point(point));
        let at = match name {
            "axle" => format!(
                "{{ from = \"wheel_centre\", offset = {} }}",
                vector([0.0, -0.1, 0.0], signs)
            ),
            "upper_rear" => continue,
            _ => vector(at.into(), signs),
        };
        writeln!(points, "{name} = {at}").unwrap();
    }
    points
}

/// The listing with its points in other axes.
fn turned(signs: [f64; 3]) -> String {
    let mut pieces = corner().split("at [");
    let mut out = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (numbers, rest) = piece.split_once(']').expect("a bracket");
        let numbers: Vec<f64> = numbers
            .split(',')
            .map(|x| x.trim().parse().unwrap())
            .collect();
        out += &format!("at {}{rest}", vector(numbers.try_into().unwrap(), signs));
    }
    out + &format!("\nmeasure {LEAN}: angle(lower_ball -> upper_ball, z);\n")
}

fn file(axes: &str, signs: [f64; 3], stated: Stated) -> String {
    let [_, y, z] = signs;
    let (linkage, points) = match stated {
        Stated::Catalogue => ("linkage = \"double_wishbone_pushrod\"", String::new()),
        Stated::File => ("linkage = \"double_wishbone_pushrod\"", points(signs)),
        Stated::Listing => ("listing = \"a.linkage\"", String::new()),
    };
    format!(
        "{linkage}\nunit = \"m\"\naxes = \"{axes}\"\nvehicle = {{ wheel_radius = 0.3 }}\n\
         time = {{ instants = [0.0] }}\n[drives]\nbump = {:?}\nsteer = {:?}\n\
         [points]\nupper_rear = {}\n{points}",
        0.3 * z,
        0.34 * y,
        vector(UPPER_REAR, signs)
    )
}

/// A sweep of the same travel and steering in any axes.
fn swept((axes, signs): (&str, [f64; 3]), stated: Stated) -> Rows {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("a.toml"), file(axes, signs, stated)).expect("written");
    std::fs::write(path("a.linkage"), turned(signs)).expect("written");
    let [_, y, z] = signs;
    let bump = format!("bump={:?}:{:?}:5", -0.06 * z, 0.06 * z);
    let steer = format!("steer={:?}", 0.01 * y);
    table_in(
        folder.path(),
        &["sweep", "a.toml", "--drive", &bump, "--drive", &steer],
    )
}

#[test]
fn a_corner_has_the_same_results_in_any_axes() {
    let expected = swept(AXES[0], Stated::Catalogue);
    for (axes, stated) in AXES.iter().flat_map(|axes| {
        [Stated::Catalogue, Stated::File, Stated::Listing].map(|stated| (*axes, stated))
    }) {
        let (_, signs) = axes;
        let sign = |name: &str| match name.rsplit_once('_') {
            Some((_, "x")) => signs[0],
            Some((_, "y")) => signs[1],
            Some((_, "z")) => signs[2],
            _ => match name {
                "bump_m" => signs[2],
                "steer_m" => signs[1],
                _ => 1.0,
            },
        };
        for (row, expected) in swept(axes, stated).iter().zip(&expected) {
            for (column, value) in expected {
                let per = column.split_once("_per_");
                let sign = match per {
                    Some((name, "bump")) => sign(name) * signs[2],
                    Some((name, _)) => sign(name) * signs[1],
                    None => sign(column),
                };
                let off = (row[column] * sign - value).abs();
                let bound = if per.is_none() { 1e-14 } else { 1e-12 };
                assert!(
                    off <= bound * value.abs().max(1.0),
                    "{axes:?} {stated:?} {column}: {} {value}",
                    row[column]
                );
            }
        }
    }
}

/// From the other end of the axis the angle is the supplement.
#[test]
fn an_angle_from_an_axis_counts_from_the_axis_of_the_file() {
    let lean = |axes| {
        let rows = swept(axes, Stated::Listing);
        rows.iter().map(|row| row["lean_rad"]).collect::<Vec<_>>()
    };
    let expected = lean(AXES[0]);
    for (axes, turned) in [(AXES[1], false), (AXES[2], true)] {
        for (found, expected) in lean(axes).iter().zip(&expected) {
            let expected = if turned { PI - expected } else { *expected };
            assert!(
                (found - expected).abs() < 1e-14,
                "{axes:?} {found} {expected}"
            );
        }
    }
}

#[test]
fn reports_and_tables_name_the_axes() {
    let folder = folder();
    let (axes, signs) = AXES[2];
    let text_of = |stated| file(axes, signs, stated);
    std::fs::write(folder.path().join("a.toml"), text_of(Stated::Catalogue)).expect("written");
    let expected = "SAE: x forward, y right, z down";
    for arguments in [
        &["motion", "a.toml"][..],
        &["motion", "a.toml", "--json", "-"],
        &["check", "a.toml"],
        &["range", "a.toml"],
    ] {
        let output = run(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        assert!(text(&output.stdout).contains(expected), "{arguments:?}");
    }
    run(folder.path(), &["sheet", "a.toml"]);
    let page = std::fs::read_to_string(folder.path().join("out/a_sheet.html")).expect("a page");
    assert!(page.contains(expected));
}

#[test]
fn unknown_axes_are_refused_with_a_suggestion() {
    let folder = folder();
    let (_, signs) = AXES[1];
    let text_of = |axes| file(axes, signs, Stated::Catalogue);
    std::fs::write(folder.path().join("a.toml"), text_of("adams")).expect("written");
    let output = run(folder.path(), &["motion", "a.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let expected = "a.toml:3:8: unknown word `adams`, expected one of `ISO 8855`, `Adams`, `SAE`; did you mean `Adams`?";
    assert_eq!(text(&output.stderr).trim_end(), expected);
}
