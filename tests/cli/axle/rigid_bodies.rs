//! Rigid axles against a solver of rigid bodies with unit quaternions, written in NumPy: quantities, and forces from the multipliers
//! of its constraints.

use std::collections::BTreeMap;

use super::super::program::{folder, rows, run};

/// The front axle of the MAN 5t of Project Chrono (`MAN_5t_FrontSolidThreeLinkAxle.json`): a triangular link, two longitudinal
/// links, a bell crank on the axle, and a drag link that moves it.
const STEERED: &str = "unit = \"m\"\nangle = \"deg\"\nstatements = '''
mirror: left -> right;
fixed: left_tri at [0.871, 0.420, 0.165], left_long at [-1.138, 0.270, 0.115], steering at [0.741, -0.217, 0.089];
free: tri_axle at [0.125, 0.0, 0.260], left_long_axle at [-0.115, 0.490, -0.090],
      left_kp_low at [0.0, 0.853748866, -0.10], left_kp_up at [0.0, 0.836251134, 0.10],
      left_knuckle_tie at [-0.236, 0.800, 0.153], left_wheel_centre at [0.0, 1.035, 0.0],
      crank_low at [-0.023, 0.0, 0.150], crank_high at [-0.023, 0.0, 0.250],
      left_crank_tie at [-0.273, 0.042, 0.153], crank_drag at [0.045, 0.256, 0.153];
hinge triangle: left_tri, right_tri -> tri_axle;
link left_longitudinal: left_long -> left_long_axle;
body axle: tri_axle, left_long_axle, right_long_axle, left_kp_low, left_kp_up, right_kp_low, right_kp_up, crank_low, crank_high;
body left_knuckle: left_kp_low, left_kp_up, left_knuckle_tie, left_wheel_centre;
body crank: crank_low, crank_high, left_crank_tie, right_crank_tie, crank_drag;
link left_tie_rod: left_crank_tie -> left_knuckle_tie;
link drag_link: steering -> crank_drag;
point left_hub: left_knuckle at [0.0, 0.937, 0.0];
drive left_bump: left_wheel_centre.z;
drive steer: steering.x;
wheel left: left_hub -> left_wheel_centre;
kingpin left: left_kp_low -> left_kp_up;
'''
vehicle = { wheel_radius = 0.62, wheelbase = 4.5, axle = \"front\" }
time = { instants = [0.0] }
drives = { left_bump = 0.0, right_bump = 0.0, steer = 0.741 }
loads.lock = { left_contact = [-20e3, 15e3, 40e3], right_contact = [-20e3, 25e3, 20e3] }
";

/// Leaf springs, each as a front link, a rear link and a shackle. They hold the axle in the middle and against wind-up.
const HOTCHKISS: &str = "unit = \"m\"\nangle = \"deg\"\nstatements = '''
mirror: left -> right;
fixed: left_eye at [0.62, 0.52, 0.38], left_shackle_top at [-0.70, 0.52, 0.50],
       foot at [0.0, 0.0, 0.2], front at [1.0, 0.0, 0.2], head at [0.0, 0.0, 0.9];
free: left_front at [0.10, 0.54, 0.27], left_rear at [-0.10, 0.54, 0.27], middle at [0.0, 0.0, 0.31],
      left_wheel_centre at [0.0, 0.74, 0.31], left_shackle at [-0.66, 0.52, 0.36];
link left_front_leaf: left_eye -> left_front;
link left_rear_leaf: left_rear -> left_shackle;
link left_swing: left_shackle_top -> left_shackle;
couple left_plane: left_shackle.y = left_rear.y;
body axle: left_front, right_front, left_rear, right_rear, middle, left_wheel_centre, right_wheel_centre;
couple wind_up: left_front.z + right_front.z = left_rear.z + right_rear.z;
plane guide: middle on foot, front, head;
point left_hub: axle at [0.0, 0.64, 0.31];
drive left_bump: left_wheel_centre.z;
wheel left: left_hub -> left_wheel_centre;
'''
vehicle = { wheel_radius = 0.31 }
time = { instants = [0.0] }
drives = { left_bump = 0.31, right_bump = 0.31 }
loads.drive = { left_contact = [3000.0, 1500.0, 5000.0], right_contact = [3000.0, 2500.0, 3000.0] }
";

/// Compares columns of `sweep` and `loads` at one place with the reference.
fn compare(file: &str, drives: &[&str], expected: &[(&str, f64)]) {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let drives = drives.iter().flat_map(|drive| ["--drive", *drive]);
    let row = |command| {
        let arguments = [command, "a.toml", "--csv", "-"].into_iter();
        let output = run(
            folder.path(),
            &arguments.chain(drives.clone()).collect::<Vec<_>>(),
        );
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        rows(&output.stdout).remove(0)
    };
    let found: BTreeMap<String, f64> = [row("sweep"), row("loads")].into_iter().flatten().collect();
    for (name, value) in expected {
        let off = (found[*name] - value).abs() / value.abs().max(1.0);
        assert!(off < 1e-8, "{name}: {} instead of {value}", found[*name]);
    }
}

#[test]
fn a_steered_axle_with_a_drag_link_moves_as_rigid_bodies() {
    let drives = ["left_bump=0.05", "right_bump=-0.08", "steer=0.12"];
    let expected = [
        ("left_toe_deg", 23.4843140398),
        ("right_toe_deg", -27.4952466131),
        ("left_camber_deg", -3.12345607451),
        ("left_kingpin_deg", 8.67274766405),
        ("right_caster_deg", -0.259306165224),
        ("left_scrub_radius_m", 0.13641420035),
        ("right_mechanical_trail_m", 0.00421632068162),
        ("left_contact_x", 0.0881185498583),
        ("axle_roll_centre_y", 0.0248512165013),
        ("axle_roll_centre_z", 0.254313359504),
        ("ackermann_percent", 82.2110095039),
        ("left_brake_angle_deg", 15.7253175291),
        ("left_virtual_kingpin_deg", 8.57411980429),
        ("right_virtual_trail_m", 0.00786149061371),
        ("lock_left_longitudinal_N", -47586.77706),
        ("lock_right_longitudinal_N", -56853.62075),
        ("lock_left_tie_rod_N", -15009.34179),
        ("lock_drag_link_N", -7919.072816),
        ("lock_left_bump_N", 51987.63659),
    ];
    compare(STEERED, &drives, &expected);
}

#[test]
fn a_hotchkiss_axle_moves_as_rigid_bodies() {
    let expected = [
        ("left_toe_deg", -0.877137863658),
        ("left_camber_deg", -4.65125164566),
        ("left_contact_x", -0.0117958723084),
        ("right_contact_x", 0.0107858835575),
        ("axle_roll_centre_y", 0.0199066682758),
        ("axle_roll_centre_z", 0.319411893549),
        ("left_roll_steer_deg_deg", 0.195008236852),
        ("left_brake_angle_deg", -4.08355346743),
        ("drive_left_front_leaf_N", -3120.90158),
        ("drive_right_front_leaf_N", -3012.35345),
        ("drive_guide_middle_y_N", -4058.7524),
        ("drive_wind_up_left_rear_z_N", 3821.87618),
        ("drive_left_bump_N", 5596.15145),
    ];
    compare(
        HOTCHKISS,
        &["left_bump=0.07", "right_bump=-0.05"],
        &expected,
    );
}
