//! Notes on what bears the torque of a driven wheel in the middle of the vehicle.

use super::super::program::{folder, rows, run};
use super::notes;

/// A motorcycle's swing arm with a marker on the upper run of its chain, and a file with more under `[vehicle]`.
fn swing_arm(vehicle: &str) -> String {
    format!(
        "statements = '''
fixed: pivot_left at [0.50, 0.12, 0.40], pivot_right at [0.50, -0.12, 0.40];
free:  wheel_centre at [0.0, 0.0, 0.32];
hinge swing_arm: pivot_left, pivot_right -> wheel_centre;
point axle:      swing_arm at [0.0, -0.1, 0.32];
point sprocket:  swing_arm at [0.0, 0.0, 0.42];
drive bump:      wheel_centre.z;
wheel:           axle -> wheel_centre;
'''
unit = \"m\"
time = {{ instants = [0.0] }}
drives = {{ bump = 0.32 }}
[vehicle]
wheel_radius = 0.31
wheelbase = 1.45
cg_height = 0.6
axle = \"rear\"
drive_share = 1.0
{vehicle}
"
    )
}

#[test]
fn a_driven_wheel_in_the_middle_is_noted() {
    let message = notes(&swing_arm(""));
    assert!(
        message.starts_with("note: a.toml: the driven wheel is in the middle, as of a motorcycle"),
        "{message}"
    );
    for bearer in ["chassis", "carrier"] {
        let file = swing_arm(&format!("drive_torque = \"{bearer}\""));
        assert_eq!(notes(&file), "");
    }
}

/// The load case of docs/limits.md against plane geometry: the lines of chain and swing arm meet at a point, and the line to it
/// from the contact point has the slope of anti-squat.
#[test]
fn a_load_case_has_the_pull_of_a_chain() {
    let (rise, run_of_chain) = (0.05, 0.58); // from the marker, 0.1 m above the wheel centre, forwards
    let length = f64::hypot(rise, run_of_chain);
    let driving = 1000.0;
    let pull = driving * 0.31 / (0.1 * run_of_chain / length);
    let [x, z] = [run_of_chain, rise].map(|part| pull * part / length);
    let loads =
        format!("[loads.drive]\ncontact = [{driving}, 0.0, 0.0]\nsprocket = [{x}, 0.0, {z}]");
    let folder = folder();
    let file = swing_arm(&format!("drive_torque = \"chassis\"\n{loads}"));
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["loads", "a.toml", "--csv", "-"]);
    let [row] = rows(&output.stdout).try_into().expect("one row");

    let ahead = 0.1 / (0.08 / 0.5 - rise / run_of_chain);
    let above_ground = 0.31 + 0.08 / 0.5 * ahead;
    let found = -row["drive_bump_N"] / driving;
    let expected = above_ground / ahead;
    assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
}
