//! The forces on the chassis at each of its points.

use nalgebra::Vector3;

use super::super::program::{folder, run, text};
use super::{force, table};

const FRONT: [f64; 3] = [0.3, 0.3, 0.2];
const REAR: [f64; 3] = [-0.3, 0.3, 0.25];
const TOP: [f64; 3] = [0.05, 0.35, 0.6];
const TIP: [f64; 3] = [0.0, 0.7, 0.2];
const HUB: [f64; 3] = [0.1, 0.6, 0.3];

/// Two links at the same chassis points, an actuator that carries both.
fn frame(more: &str) -> String {
    format!(
        "unit = \"m\"\nstatements = \"\"\"\nfixed: front at {FRONT:?}, rear at {REAR:?}, top at {TOP:?};\n\
         free: tip at {TIP:?}, hub at {HUB:?};\n\
         link fore: front -> tip;\nlink aft: rear -> tip;\nlink brace: tip -> hub;\n\
         link inner_fore: front -> hub;\nlink inner_aft: rear -> hub;\ndrive ram: length(top -> tip);\n\"\"\"\n\
         time = {{ instants = [0.0] }}\ndrives = {{ ram = {} }}\n{more}\n",
        (Vector3::from(TOP) - Vector3::from(TIP)).norm()
    )
}

const LOADS: [[f64; 3]; 2] = [[-500.0, 300.0, 4000.0], [800.0, -200.0, 100.0]];

/// Returns the case of the frame, and its loads there.
fn loaded() -> String {
    let [tip, hub] = LOADS;
    frame(&format!("[loads.a]\ntip = {tip:?}\nhub = {hub:?}"))
}

/// Two links share a bracket, an actuator pushes at another; all brackets together bear the loads.
#[test]
fn forces_of_links_and_actuators_at_a_chassis_point_are_added() {
    let row = &table(&loaded(), &[])[0];
    let pull = |link: &str, from, to| {
        let along = Vector3::from(to) - Vector3::from(from);
        along.normalize() * row[&format!("a_{link}_N")]
    };
    let on = |point: &str| force(row, &format!("a_on_chassis_{point}"));
    let at_front = pull("fore", FRONT, TIP) + pull("inner_fore", FRONT, HUB);
    let at_rear = pull("aft", REAR, TIP) + pull("inner_aft", REAR, HUB);
    assert!((on("front") - at_front).norm() < 1e-9, "{row:?}");
    assert!((on("rear") - at_rear).norm() < 1e-9, "{row:?}");
    let ram = (Vector3::from(TIP) - Vector3::from(TOP)).normalize();
    assert!(on("top").cross(&ram).norm() < 1e-9, "{row:?}");
    let [tip, hub] = LOADS.map(Vector3::from);
    let all = on("front") + on("rear") + on("top");
    assert!((all - tip - hub).norm() < 1e-9, "{row:?}");
    let places = [("front", FRONT), ("rear", REAR), ("top", TOP)];
    let moments = places.map(|(point, at)| Vector3::from(at).cross(&on(point)));
    let of_loads = Vector3::from(TIP).cross(&tip) + Vector3::from(HUB).cross(&hub);
    let off = moments.iter().sum::<Vector3<f64>>() - of_loads;
    assert!(off.norm() < 1e-9, "{row:?}");
}

/// A link with a mass is among the joints too, and counts once; the weight of all is borne.
#[test]
fn forces_on_the_chassis_sum_to_loads_and_weights() {
    let masses =
        "[masses]\nfore = 3.0\nbrace = 2.0\ntip = 10.0\n[loads.a]\nhub = [0.0, 0.0, 500.0]";
    let row = &table(&frame(masses), &[])[0];
    let on = ["front", "rear", "top"].map(|point| force(row, &format!("a_on_chassis_{point}")));
    let expected = Vector3::new(0.0, 0.0, 500.0 - 15.0 * 9.80665);
    let all: Vector3<f64> = on.iter().sum();
    assert!((all - expected).norm() < 1e-9, "{all:?}");
}

#[test]
fn the_loads_report_has_a_table_of_forces_on_the_chassis() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), loaded()).expect("written");
    let row = &table(&loaded(), &[])[0];
    let report = run(folder.path(), &["loads", "a.toml"]);
    let report = text(&report.stdout);
    let begins = report.find("chassis point  ").expect("the table");
    let line = report[begins..]
        .lines()
        .find(|line| line.starts_with("front "));
    let words: Vec<&str> = line.expect("its row").split_whitespace().collect();
    let expected = force(row, "a_on_chassis_front");
    let expected = ["front".to_owned()]
        .into_iter()
        .chain(expected.iter().map(|force| format!("{force:.1}")));
    let expected: Vec<String> = expected.chain(["N".to_owned()]).collect();
    assert_eq!(words, expected, "{report}");
}

/// The report answers why a drive bears nothing, what moves, and how bushes share a load.
#[test]
fn the_loads_report_explains_borne_loads_and_shares_of_bushes() {
    let rocker = include_str!("../../../examples/double_wishbone_rocker.toml");
    let without_spring = rocker.replace("bump = \"damper\"\n", "");
    let note = |hinges: &str| {
        format!(
            "note: a.toml: each of the two bushes of the hinges {hinges} is given half of the load along the axis: rigid parts do not determine \
             the shares\n"
        )
    };
    for (file, drive, note) in [
        (
            rocker,
            "bump (its load is in damper)     0.0 N",
            note("`lower_wishbone`, `upper_wishbone` and `rocker`"),
        ),
        (
            &without_spring,
            "\nbump   4004.5 N",
            note("`lower_wishbone` and `upper_wishbone`"),
        ),
    ] {
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let output = run(folder.path(), &["loads", "a.toml"]);
        let report = text(&output.stdout).to_owned();
        for expected in [drive, "\nrack (driven) ", "\nlower_front "] {
            assert!(report.contains(expected), "{expected}: {report}");
        }
        let to_a_table = run(folder.path(), &["loads", "a.toml", "--csv", "-"]);
        for output in [output, to_a_table] {
            assert_eq!(text(&output.stderr).matches(&note).count(), 1, "{output:?}");
        }
    }
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), loaded()).expect("written");
    let output = run(folder.path(), &["loads", "a.toml"]);
    let report = text(&output.stdout);
    assert!(!text(&output.stderr).contains("hinge"), "{output:?}");
    assert!(
        !report.contains("hinge") && !report.contains("(driven)"),
        "{report}"
    );
}
