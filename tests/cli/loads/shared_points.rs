//! Two bodies that share two points, as an arm and its knuckle share the ends of a kingpin.

use nalgebra::Vector3;

use super::{force, table};
use crate::program::{folder, run, text};

/// A knuckle on a vertical kingpin of an arm. The upper end of the kingpin is driven, and forces act at the hub.
fn kingpin([arm, knuckle]: [&str; 2], ends: &str) -> String {
    format!(
        "unit = \"m\"\nstatements = \"\"\"\n\
         fixed: front at [0.3, 0.3, 0.2], rear at [-0.3, 0.3, 0.2], rack at [0.1, 0.3, 0.2];\n\
         free: low at [0.0, 0.75, 0.1], high at [0.0, 0.75, 0.4], tie at [0.1, 0.7, 0.2], hub at [0.0, 0.8, 0.25];\n\
         {arm}{ends};\n{knuckle}{ends}, tie, hub;\nlink tie_rod: rack -> tie;\ndrive bump: high.z;\n\"\"\"\n\
         time = {{ instants = [0.0] }}\ndrives = {{ bump = 0.4 }}\n[loads.a]\nhub = [300.0, 200.0, 500.0]\n"
    )
}

const ARM: &str = "hinge arm: front, rear -> ";
const KNUCKLE: &str = "body knuckle: ";

/// How they share the force along their line is not determined: each has half of what the bodies pass on there, in whatever
/// order the points are stated.
#[test]
fn two_shared_points_of_bodies_share_the_axial_force_equally() {
    for ends in ["low, high", "high, low"] {
        let row = &table(&kingpin([ARM, KNUCKLE], ends), &[])[0];
        let [knuckle_low, knuckle_high, arm_low, arm_high] =
            ["knuckle_low", "knuckle_high", "arm_low", "arm_high"]
                .map(|joint| force(row, &format!("a_{joint}")));
        let borne = knuckle_low.z + knuckle_high.z;
        assert!((borne - 500.0).abs() < 1e-9, "{ends}: {borne}");
        let passed_on = [(knuckle_low - arm_low).z, (knuckle_high - arm_high).z];
        assert!(
            (passed_on[0] - passed_on[1]).abs() < 1e-9,
            "{ends}: {passed_on:?}"
        );
        // The drive takes the vertical load at the upper point; across the line the forces stay as they are.
        assert!(
            (knuckle_low + arm_low).norm() < 1e-9,
            "{ends}: {knuckle_low} {arm_low}"
        );
        let upper: Vector3<f64> = knuckle_high + arm_high;
        assert!(upper.xy().norm() < 1e-9, "{ends}: {upper}");
    }
}

#[test]
fn a_note_explains_the_equal_shares_of_two_shared_points() {
    let folder = folder();
    let file = kingpin([ARM, KNUCKLE], "low, high");
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["loads", "a.toml"]);
    let note = "note: a.toml: each of the two points that `arm` and `knuckle` share is given half of the load along the line of these \
                points: rigid parts do not determine the shares\n";
    assert!(text(&output.stderr).contains(note), "{output:?}");
}

/// A plate on three links, and a statement that names three points of the plate without being a rigid part.
fn plate(statement: &str, drives: &str) -> String {
    format!(
        "unit = \"m\"\nstatements = \"\"\"\n\
         fixed: front_a at [0.5, 0.5, 0.3], front_b at [0.5, -0.5, 0.3], side at [-0.3, -0.5, 0.3];\n\
         free: a at [0.0, 0.5, 0.3], b at [0.0, -0.5, 0.3], c at [-0.3, 0.0, 0.3];\n\
         link along_a: front_a -> a;\nlink along_b: front_b -> b;\nlink across: side -> c;\nbody plate: a, b, c;\n\
         point hub: plate at [0.1, 0.2, 0.0];\n{statement}\ndrive left: a.z;\n{drives}\"\"\"\n\
         time = {{ instants = [0.0] }}\ndrives = {{ left = 0.3, right = 0.3 }}\n[loads.a]\nhub = [300.0, 200.0, 500.0]\n"
    )
}

/// The plate passes the load on; the statement that names its points exerts only the force of its own equation.
#[test]
fn a_load_on_a_body_is_not_one_on_a_statement_that_names_the_same_points() {
    let file = plate("couple level: a.z + b.z = 2 c.z;", "drive right: b.z;\n");
    let row = &table(&file, &[])[0];
    let [at_a, at_b, at_c] = ["a", "b", "c"].map(|point| force(row, &format!("a_level_{point}")));
    assert!(at_a.z.abs() > 1.0, "{at_a}");
    let along = [at_a, at_b, at_c / -2.0].map(|force| force - Vector3::new(0.0, 0.0, at_a.z));
    let off: Vec<f64> = along.iter().map(Vector3::norm).collect();
    assert!(off.iter().all(|off| *off < 1e-9), "{at_a} {at_b} {at_c}");
    let plate = ["a", "b", "c"].map(|point| force(row, &format!("a_plate_{point}")));
    let load = Vector3::new(300.0, 200.0, 500.0);
    let off = plate.iter().sum::<Vector3<f64>>() - load;
    assert!(off.norm() < 1e-9, "{plate:?}");
}
