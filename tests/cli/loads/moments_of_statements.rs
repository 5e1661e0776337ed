//! Moments of statements that drive or hold an angle, on the parts that carry the lines of the angle.

use std::collections::BTreeMap;

use nalgebra::Vector3;

use super::super::program::{folder, run, text};
use super::{force, table};

const POINTS: [(&str, [f64; 3]); 8] = [
    ("front", [0.4, 0.3, 0.25]),
    ("rear", [-0.4, 0.28, 0.28]),
    ("mark", [-0.38, 0.1, 0.6]),
    ("inner", [-0.03, 0.32, 0.22]),
    ("aft", [-0.2, 0.36, 0.27]),
    ("outer", [0.0, 0.7, 0.19]),
    ("left", [0.05, 0.33, 0.24]),
    ("right", [-0.07, 0.31, 0.23]),
];

/// Returns a link on a subframe that a drive turns, with a universal joint against spinning; lengths in the file are
/// multiplied by `size`.
fn file(unit: &str, size: f64) -> String {
    let points = POINTS.map(|(name, at)| format!("{name} = {:?}\n", at.map(|along| along * size)));
    format!(
        "unit = \"{unit}\"\nstatements = '''\nfixed: front, rear, mark;\nfree: inner, aft, outer, left, right;\n\
         hinge subframe: front, rear -> inner, aft;\nbody arm: inner, outer, left, right;\n\
         angle cross: left -> right, inner -> aft;\ndrive rock: angle(rear -> mark, rear -> aft about rear -> front);\n\
         drive bump: outer.z;\ndrive swing: outer.x;\n'''\ntime = {{ instants = [0.0] }}\n[points]\n{}[drives]\nrock = 1.0\n\
         bump = {:?}\nswing = 0.0\n[loads.c]\nleft = [30.0, 100.0, -400.0]\n",
        points.concat(),
        0.19 * size
    )
}

/// The moment of all that a part exerts at its points.
fn passed_on(row: &BTreeMap<String, f64>, part: &str) -> Vector3<f64> {
    let all = POINTS.iter().filter_map(|(point, at)| {
        let name = format!("c_{part}_{point}");
        let is_joint = row.contains_key(&format!("{name}_x_N"));
        is_joint.then(|| Vector3::from(*at).cross(&force(row, &name)))
    });
    all.sum()
}

fn moment(row: &BTreeMap<String, f64>, name: &str) -> Vector3<f64> {
    Vector3::from(["x", "y", "z"].map(|axis| row[&format!("c_{name}_{axis}_Nm")]))
}

/// A universal joint turns both parts by opposite moments; with that of the drive, each part is in equilibrium.
#[test]
fn parts_are_in_equilibrium_with_driven_and_held_angles() {
    for (unit, size) in [("m", 1.0), ("mm", 1000.0)] {
        let row = &table(&file(unit, size), &[])[0];
        let [on_arm, on_subframe, rock] =
            ["cross_arm", "cross_subframe", "rock_subframe"].map(|name| moment(row, name));
        assert!(on_arm.norm() > 5.0, "{unit}: {on_arm:?}");
        assert!((on_arm + on_subframe).norm() < 1e-8, "{unit}: {row:?}");
        for (part, moments) in [("arm", on_arm), ("subframe", on_subframe + rock)] {
            let off = passed_on(row, part) - moments;
            assert!(off.norm() < 1e-8, "{unit} {part}: {off:?}");
        }
        // About the subframe's own axis.
        let axis = Vector3::from(POINTS[0].1) - Vector3::from(POINTS[1].1);
        let borne = -rock.dot(&axis.normalize());
        assert!((borne - row["c_rock_Nm"]).abs() < 1e-8, "{unit}: {row:?}");
        assert!(rock.cross(&axis).norm() < 1e-8, "{unit}: {rock:?}");
    }
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file("m", 1.0)).expect("written");
    let output = run(folder.path(), &["loads", "a.toml"]);
    for name in ["cross on arm", "cross on subframe", "rock on subframe"] {
        assert!(text(&output.stdout).contains(name), "{output:?}");
    }
}
