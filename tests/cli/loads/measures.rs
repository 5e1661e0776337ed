//! Loads in measures, for example of a coil spring, on the bodies and the chassis between which they act.

use std::collections::BTreeMap;

use nalgebra::Vector3;

use super::super::program::{folder, run, text};
use super::{force, swept, table};

type Row = BTreeMap<String, f64>;

/// A layout of the catalogue with a wheel that brakes and corners; the spring bears the load of the drive of travel.
fn braking(layout: &str, drives: &str, more: &str) -> String {
    format!(
        "linkage = \"{layout}\"\nunit = \"m\"\nvehicle = {{ wheel_radius = 0.3 }}\ntime = {{ instants = [0.0] }}\n[drives]\n{drives}\n\
         [springs.coil]\nalong = \"damper\"\nrate = 40000.0\n[loads.a]\ncontact = [-3000.0, 700.0, 4000.0]\n{more}\n"
    )
}

/// Returns all forces that a part exerts, with the positions of its points.
fn exerted(row: &Row, place: &Row, part: &str) -> Vec<[Vector3<f64>; 2]> {
    let begins = format!("a_{part}_");
    let points = row.keys().filter_map(|name| {
        name.strip_prefix(&begins)?
            .strip_suffix("_x_N")
            .map(str::to_owned)
    });
    let read = |point: String| [at(place, &point), force(row, &format!("a_{part}_{point}"))];
    points.map(read).collect()
}

fn at(place: &Row, point: &str) -> Vector3<f64> {
    Vector3::from(["x", "y", "z"].map(|axis| place[&format!("{point}_{axis}")]))
}

/// The sum of forces, and of their moments about the origin.
fn sum(forces: &[[Vector3<f64>; 2]]) -> [Vector3<f64>; 2] {
    let moments = forces.iter().map(|[at, force]| at.cross(force));
    [
        forces.iter().map(|[_, force]| force).sum(),
        moments.sum::<Vector3<f64>>(),
    ]
}

/// A chassis point of a layout, and its position.
type Chassis = (&'static str, [f64; 3]);

const COILOVER: [Chassis; 6] = [
    ("lower_front", [0.20, 0.35, 0.16]),
    ("lower_rear", [-0.20, 0.35, 0.16]),
    ("upper_front", [0.15, 0.42, 0.42]),
    ("upper_rear", [-0.15, 0.42, 0.42]),
    ("rack", [0.11, 0.34, 0.20]),
    ("damper_upper", [-0.02, 0.46, 0.64]),
];

const STRUT: [Chassis; 4] = [
    ("lower_front", [0.01, 0.36, 0.19]),
    ("lower_rear", [-0.30, 0.37, 0.20]),
    ("rack", [-0.14, 0.33, 0.25]),
    ("top", [-0.03, 0.575, 0.83]),
];

/// Returns the positions of all points, at values of the drive of travel.
fn places(file: &str, more: &[&str], chassis: &[Chassis]) -> Vec<Row> {
    let mut places = swept(file, more);
    for place in &mut places {
        for (point, at) in chassis {
            let coordinates = ["x", "y", "z"].iter().zip(at);
            place.extend(coordinates.map(|(axis, at)| (format!("{point}_{axis}"), *at)));
        }
    }
    places
}

/// The forces of each body are in equilibrium, with the load on the carrier at the contact point; so are those at the joint
/// of the spring's lower end, and the chassis bears the load.
fn assert_balanced(file: &str, parts: &[&str], [carrier, joint]: [&str; 2], chassis: &[Chassis]) {
    let more = ["--drive", "bump=-0.04:0.04:3"];
    let (loads, places) = (table(file, &more), places(file, &more, chassis));
    assert_eq!((loads.len(), places.len()), (3, 3));
    for (row, place) in loads.iter().zip(&places) {
        let load = Vector3::new(-3000.0, 700.0, 4000.0);
        let load = [load, at(place, "contact").cross(&load)];
        for part in parts {
            let expected = match *part == carrier {
                true => load,
                false => [Vector3::zeros(); 2],
            };
            assert_near(sum(&exerted(row, place, part)), expected, part);
        }
        let all: Vec<_> = parts
            .iter()
            .flat_map(|part| exerted(row, place, part))
            .collect();
        let joined = all.iter().filter(|[point, _]| *point == at(place, joint));
        let joined: Vec<_> = joined.copied().collect();
        assert!(joined.len() > 1);
        assert_near(sum(&joined), [Vector3::zeros(); 2], joint);
        let is_chassis = |position| {
            chassis
                .iter()
                .any(|(point, _)| at(place, point) == position)
        };
        let on_chassis = all.into_iter().filter(|[point, _]| is_chassis(*point));
        let [rack, tie_ball] = ["rack", "tie_ball"].map(|point| at(place, point));
        let pull = (tie_ball - rack).normalize() * row["a_tie_rod_N"];
        let on_chassis: Vec<_> = on_chassis.chain([[rack, pull]]).collect();
        assert_near(sum(&on_chassis), load, "chassis");
        let together = exerted(row, place, "on_chassis");
        assert_eq!(together.len(), chassis.len());
        assert_near(sum(&together), load, "all on the chassis");
    }
}

fn assert_near(found: [Vector3<f64>; 2], expected: [Vector3<f64>; 2], what: &str) {
    for (found, expected) in found.iter().zip(expected) {
        let off = (found - expected).norm();
        assert!(off < 1e-8, "{what}: {found:?}, not {expected:?}");
    }
}

/// The lower wishbone carries the lower end of the damper.
#[test]
fn parts_of_a_wishbone_with_a_coilover_are_in_equilibrium() {
    let drives = "bump = 0.3\nsteer = 0.34";
    for more in ["bump = \"coil\"", "damper = 5000.0\nbump = \"damper\""] {
        assert_balanced(
            &braking("double_wishbone_coilover", drives, more),
            &["lower_wishbone", "upper_wishbone", "upright", "damper"],
            ["upright", "damper_lower"],
            &COILOVER,
        );
    }
}

/// The top mount bears the spring and the transverse force of the strut.
#[test]
fn parts_of_a_macpherson_strut_are_in_equilibrium() {
    let drives = "bump = 0.31\nsteer = 0.33";
    assert_balanced(
        &braking("macpherson", drives, "bump = \"coil\""),
        &["lower_arm", "knuckle", "strut", "damper"],
        ["knuckle", "strut_low"],
        &STRUT,
    );
}

/// The spring pushes its ends apart along the damper, the upper one upwards.
#[test]
fn the_top_mount_bears_the_spring_force_along_the_damper() {
    let drives = "bump = 0.3\nsteer = 0.34";
    let file = braking("double_wishbone_coilover", drives, "bump = \"coil\"");
    let row = &table(&file, &[])[0];
    let place = &places(&file, &["--drive", "bump=0.0"], &COILOVER)[0];
    let along = (at(place, "damper_upper") - at(place, "damper_lower")).normalize();
    let expected = along * row["a_damper_N"];
    let found = force(row, "a_damper_damper_upper");
    assert!((found - expected).norm() < 1e-8, "{found:?}");
    assert!(found.z > 4000.0, "{found:?}");
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), &file).expect("written");
    let output = run(folder.path(), &["loads", "a.toml"]);
    let report = text(&output.stdout);
    for joint in [
        "lower_wishbone at damper_lower",
        "damper at damper_lower",
        "damper at damper_upper",
    ] {
        assert!(report.contains(joint), "{joint}: {report}");
    }
}

/// A force that is stated in the measure whose spring bears the rest: the row has the sum, as the joints at its ends do, and says so.
#[test]
fn the_row_of_a_spring_includes_a_stated_force() {
    let drives = "bump = 0.3\nsteer = 0.34";
    let alone = braking("double_wishbone_coilover", drives, "bump = \"coil\"");
    let both = braking(
        "double_wishbone_coilover",
        drives,
        "damper = 1200.0\nbump = \"coil\"",
    );
    let (spring, sum) = (&table(&alone, &[])[0], &table(&both, &[])[0]);
    for row in [spring, sum] {
        let end = force(row, "a_damper_damper_upper").norm();
        assert!((row["a_damper_N"] - end).abs() < 1e-8, "{end}: {row:?}");
    }
    assert!((sum["a_damper_N"] - spring["a_damper_N"]).abs() < 1e-8);
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), &both).expect("written");
    let output = run(folder.path(), &["loads", "a.toml"]);
    let report = text(&output.stdout);
    let expected = format!(
        "\ndamper (spring coil and the stated 1200.0 N)  {:.1} N\n",
        sum["a_damper_N"]
    );
    assert!(report.contains(&expected), "{expected}: {report}");
}
