//! Moments of loads in measured angles, on the parts that carry the lines of the angle.

use nalgebra::Vector3;

use super::super::program::{folder, run, text};
use super::{force, table};

/// Returns a trailing arm, 0.4 m long, with a torsion bar along its axis; lengths in the file are multiplied by `size`.
fn arm(unit: &str, size: f64, case: &str) -> String {
    let at = |x: f64, y: f64, z: f64| format!("[{:?}, {:?}, {:?}]", x * size, y * size, z * size);
    format!(
        "statements = '''\nfixed: outer at {}, inner at {}, mark at {};\nfree: hub at {};\nhinge arm: outer, inner -> hub;\n\
         drive bump: hub.z;\nmeasure bar: angle(inner -> mark, outer -> hub about inner -> outer);\n'''\n\
         unit = \"{unit}\"\ntime = {{ instants = [0.0] }}\n[drives]\nbump = {:?}\n[loads.c]\nhub = [0.0, 0.0, 1000.0]\n{case}\n",
        at(0.4, 0.6, 0.3),
        at(0.4, 0.3, 0.3),
        at(-0.1, 0.3, 0.3),
        at(0.0, 0.45, 0.3),
        0.3 * size
    )
}

fn moment(row: &std::collections::BTreeMap<String, f64>, name: &str) -> Vector3<f64> {
    Vector3::from(["x", "y", "z"].map(|axis| row[&format!("{name}_{axis}_Nm")]))
}

/// A case may state the load, the measure may bear that of a drive, or both: the loads are added.
#[test]
fn the_moment_of_a_torsion_bar_acts_on_the_arm() {
    for (case, expected) in [
        ("bar = -300.0", -300.0),
        ("bump = \"bar\"", -400.0),
        ("bump = \"bar\"\nbar = -300.0", -400.0),
    ] {
        for (unit, size) in [("m", 1.0), ("mm", 1000.0)] {
            let row = &table(&arm(unit, size, case), &[])[0];
            let found = moment(row, "c_bar_arm");
            let off = found - Vector3::new(0.0, expected, 0.0);
            assert!(off.norm() < 1e-8, "{unit} {case}: {found:?}");
        }
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), arm("m", 1.0, case)).expect("written");
        let output = run(folder.path(), &["loads", "a.toml"]);
        let row = format!("bar on arm  0.0  {expected:.1}  0.0 N m\n");
        assert!(text(&output.stdout).contains(&row), "{output:?}");
    }
    let row = &table(&arm("m", 1.0, ""), &[])[0];
    assert!(!row.keys().any(|name| name.contains("bar")), "{row:?}");
}

/// An arm on a moving body: a load between both acts on the two with opposite signs, and each body is in equilibrium.
#[test]
fn a_load_in_an_angle_acts_oppositely_on_both_bodies() {
    let file = "statements = '''\nfixed: f1 at [0.3, 0.3, 0.2], f2 at [-0.3, 0.3, 0.2];
free: e at [0.0, 0.6, 0.2], f at [0.0, 0.6, 0.5], n at [0.2, 0.5, 0.2], a at [0.15, 0.65, 0.35];
hinge car: f1, f2 -> e, f, n;
body arm: e, f, a;
drive up: n.z;
drive turn: a.y;
measure bar: angle(e -> n, e -> a about e -> f);\n'''\nunit = \"m\"\ntime = { instants = [0.0] }\n\
                drives = { up = 0.2, turn = 0.65 }\nloads.c = { a = [0.0, 100.0, 0.0], turn = \"bar\" }\n";
    let row = &table(file, &[])[0];
    let [on_car, on_arm] = ["car", "arm"].map(|body| moment(row, &format!("c_bar_{body}")));
    assert!((on_car + on_arm).norm() < 1e-8, "{on_car:?} {on_arm:?}");
    assert!((on_arm.norm() - row["c_bar_Nm"].abs()).abs() < 1e-8);
    let joints = [
        ("e", [0.0, 0.6, 0.2]),
        ("f", [0.0, 0.6, 0.5]),
        ("a", [0.15, 0.65, 0.35]),
    ];
    let joints =
        joints.map(|(joint, at)| Vector3::from(at).cross(&force(row, &format!("c_arm_{joint}"))));
    let passed_on: Vector3<f64> = joints.iter().sum();
    assert!(
        (passed_on - on_arm).norm() < 1e-8,
        "{passed_on:?} {on_arm:?}"
    );
}
