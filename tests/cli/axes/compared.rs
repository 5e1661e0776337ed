//! Comparisons of a corner with the same corner in other axes.

use std::process::Output;

use super::super::program::{folder, run, text};
use super::{AXES, Stated, file, turned};

/// A file in millimetres.
fn in_millimetres((axes, signs): (&str, [f64; 3]), stated: Stated) -> String {
    let metres = file(axes, signs.map(|sign| 1000.0 * sign), stated);
    metres
        .replace("unit = \"m\"", "unit = \"mm\"")
        .replace("wheel_radius = 0.3", "wheel_radius = 300.0")
}

/// A comparison of two files, of which the second may refer to a listing.
fn compare(a: &str, b: &str, listing: &str) -> [Output; 2] {
    let folder = folder();
    for (name, content) in [("a.toml", a), ("b.toml", b), ("a.linkage", listing)] {
        std::fs::write(folder.path().join(name), content).expect("written");
    }
    let arguments = ["compare", "a.toml", "b.toml", "--csv", "-"];
    [&arguments[..], &arguments[..3]].map(|arguments| run(folder.path(), arguments))
}

#[test]
fn a_corner_compares_equal_to_itself_in_other_axes_and_units() {
    let iso = file(AXES[0].0, AXES[0].1, Stated::Catalogue);
    for axes in AXES {
        for stated in [Stated::File, Stated::Listing] {
            let scaled = turned(axes.1.map(|sign| 1000.0 * sign));
            let [csv, report] = compare(&iso, &in_millimetres(axes, stated), &scaled);
            assert_eq!(csv.status.code(), Some(0), "{csv:?}");
            let mut reader = csv::Reader::from_reader(csv.stdout.as_slice());
            let mut sorts = std::collections::BTreeMap::new();
            for record in reader.records() {
                let record = record.expect("a row");
                let [a, difference] =
                    [4, 6].map(|column| record[column].parse::<f64>().expect("a number"));
                assert!(
                    difference.abs() <= 1e-11 * a.abs().max(1.0),
                    "{axes:?} {stated:?} {record:?}"
                );
                *sorts.entry(record[0].to_owned()).or_insert(0) += 1;
            }
            let sorts: Vec<_> = sorts.into_iter().collect();
            assert_eq!(sorts.len(), 5, "{sorts:?}");
            assert!(sorts.iter().all(|(_, count)| *count > 20), "{sorts:?}");
            let converted = match axes.0 {
                "ISO 8855" => ", converted from mm to m)".to_owned(),
                other => format!(", converted from mm to m and from axes {other} to ISO 8855)"),
            };
            assert!(text(&report.stdout).contains(&converted), "{report:?}");
        }
    }
}

#[test]
fn compared_positions_are_in_the_axes_of_the_first_file() {
    let [sae, iso] = [AXES[2], AXES[0]].map(|(axes, signs)| file(axes, signs, Stated::Catalogue));
    let [csv, _] = compare(&sae, &iso, "");
    let mut reader = csv::Reader::from_reader(csv.stdout.as_slice());
    let records = reader.records().map(|record| record.expect("a row"));
    let centre: Vec<_> = records
        .filter(|record| &record[0] == "design" && &record[1] == "wheel centre z")
        .map(|record| [4, 5].map(|column| record[column].parse::<f64>().expect("a number")))
        .collect();
    assert_eq!(centre, [[-0.3, -0.3]]);
}

/// In roll the left wheel rises, in any axes, as in the definition of roll camber and roll steer.
#[test]
fn the_left_wheel_rises_in_compared_roll_in_any_axes() {
    for (axes, [_, across, up]) in AXES {
        let axle = format!(
            "linkage = \"steered_axle\"\nunit = \"m\"\naxes = \"{axes}\"\nvehicle = {{ wheel_radius = 0.3 }}\n\
             time = {{ instants = [0.0] }}\n[drives]\nbump_left = {:?}\nbump_right = {:?}\nsteer = {:?}\n",
            0.3 * up,
            0.3 * up,
            0.34 * across,
        );
        let [_, report] = compare(&axle, &axle, "");
        let heading = "over roll, at a change of bump_left upwards and of bump_right downwards";
        assert!(text(&report.stdout).contains(heading), "{axes}: {report:?}");
    }
}

/// A rack that moves obliquely, and an oblique pair of coupled coordinates, would change if only one of the axes turned.
#[test]
fn comparing_is_refused_if_other_axes_change_the_mechanism() {
    let skew = |axes: (&str, [f64; 3])| {
        let listing = turned(axes.1).replace(
            "drive steer: rack.y;",
            "drive steer: rack along [0.1, 1.0, 0.0];",
        );
        (file(axes.0, axes.1, Stated::Listing), listing)
    };
    let iso = file(AXES[0].0, AXES[0].1, Stated::Catalogue);
    let (adams, listing) = skew(AXES[1]);
    let [output, _] = compare(&iso, &adams, &listing);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let (sae, listing) = skew(AXES[2]);
    let [output, _] = compare(&iso, &sae, &listing);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let expected = "b.toml: `steer` joins coordinates, and only some of them change sign from axes SAE to ISO 8855; state both \
                    files in the same axes\n";
    assert_eq!(text(&output.stderr), expected);
    let stated =
        file(AXES[2].0, AXES[2].1, Stated::Catalogue) + "[design]\nbump = -0.3\nsteer = -0.34\n";
    let [output, _] = compare(&iso, &stated, "");
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(
        text(&output.stderr).contains("[design] is in axes SAE, not ISO 8855"),
        "{output:?}"
    );
}
