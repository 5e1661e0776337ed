//! Roll centre, roll camber and roll steer.

use super::super::program::{folder, run, text};
use super::{DESIGN, Row, assert_near, file, steered, table};

/// Returns the drives' rates at which the left contact point rises by one and the right one falls by one.
fn in_roll(row: &Row) -> [f64; 2] {
    let rise = |wheel: &str, drive: &str| row[&format!("{wheel}_contact_z_per_bump_{drive}")];
    let [a, b] = ["left", "right"].map(|drive| rise("left", drive));
    let [c, d] = ["left", "right"].map(|drive| rise("right", drive));
    let determinant = a * d - b * c;
    [(d + b) / determinant, -(a + c) / determinant]
}

/// A tenth of a millimetre of roll either way.
#[test]
fn roll_camber_and_roll_steer_agree_with_differences() {
    for (left, right, steer) in [(0.3, 0.3, 0.34), (0.33, 0.29, 0.345), (0.27, 0.31, 0.325)] {
        let held = format!("bump_left = {left}\nbump_right = {right}\nsteer = {steer}");
        let [dl, dr, ds] = [left - 0.3, right - 0.3, steer - 0.34];
        let arguments = [
            format!("--drive=bump_left={dl}"),
            format!("--drive=bump_right={dr}"),
            format!("--drive=steer={ds}"),
        ];
        let [a, b, c] = arguments.each_ref().map(String::as_str);
        let here = table(&steered(&held), &["sweep", a, b, c]).remove(0);
        let [p, q] = in_roll(&here);
        let rolling =
            format!("bump_left = [{left}, {p:?}]\nbump_right = [{right}, {q:?}]\nsteer = {steer}");
        let states = table(&steered(&rolling), &["motion"]);
        let [before, now, after] = states.as_slice() else {
            panic!("three instants");
        };
        let roll = |row: &Row| {
            let line = ["y", "z"].map(|axis| {
                row[&format!("left_contact_{axis}")] - row[&format!("right_contact_{axis}")]
            });
            line[1].atan2(line[0])
        };
        for wheel in ["left", "right"] {
            for (roll_name, name) in [("roll_camber", "camber"), ("roll_steer", "steer_angle")] {
                let of = format!("{wheel}_{name}_rad");
                let slope = (after[&of] - before[&of]) / (roll(after) - roll(before));
                let found = now[&format!("{wheel}_{roll_name}_rad_rad")];
                let tolerance = 1e-6 * slope.abs();
                assert_near(found, slope, tolerance, &format!("{wheel} {roll_name}"));
                assert!(slope.abs() > 1e-3, "{slope}");
            }
        }
    }
}

/// The axle turns about a line in the plane of symmetry: through where the lower links' lines meet, and where those of
/// the upper ones do.
#[test]
fn a_live_axle_has_the_roll_steer_of_its_geometric_roll_axis() {
    let drives = "bump_left = 0.31\nbump_right = 0.31";
    let axle = file("live_axle_splayed", "", drives);
    let row = table(&axle, &["motion"]).remove(1);
    let met = |front: [f64; 3], rear: [f64; 3]| {
        let part = front[1] / (front[1] - rear[1]);
        [0, 2].map(|axis: usize| front[axis] + part * (rear[axis] - front[axis]))
    };
    let lower = met([0.56, 0.46, 0.29], [0.02, 0.50, 0.24]);
    let upper = met([0.34, 0.42, 0.44], [0.02, 0.12, 0.43]);
    let slope = (upper[1] - lower[1]) / (upper[0] - lower[0]);
    let height = lower[1] - slope * lower[0];
    assert_near(row["axle_roll_centre_y"], 0.0, 1e-12, "roll centre");
    assert_near(row["axle_roll_centre_z"], height, 1e-10, "roll centre");
    for wheel in ["left", "right"] {
        let steer = row[&format!("{wheel}_roll_steer_rad_rad")];
        assert_near(steer, slope, 1e-10, "roll steer");
    }
    // The wheels lean with the axle: the top of the left one inboard as it rises.
    assert_near(row["left_roll_camber_rad_rad"], -1.0, 1e-10, "roll camber");
    assert_near(row["right_roll_camber_rad_rad"], 1.0, 1e-10, "roll camber");
}

/// The height of the roll centre of an axle that is symmetric, by one of its wheels.
#[test]
fn the_roll_centre_of_a_symmetric_axle_equals_that_of_each_wheel() {
    let row = table(&steered(DESIGN), &["motion"]).remove(1);
    let ground = row["left_contact_z"];
    for wheel in ["left", "right"] {
        let of_wheel = row[&format!("{wheel}_roll_centre_m")] + ground;
        assert_near(row["axle_roll_centre_z"], of_wheel, 1e-12, wheel);
    }
}

/// Wheels of a twist beam move each other: the lifting effect of a lateral force on one of them does not depend on its own
/// arm alone, and the roll centre is that of the axle.
#[test]
fn coupled_wheels_have_no_roll_centre_of_their_own() {
    let names = |linkage: &str, drives: &str| {
        let folder = folder();
        let file = format!(
            "linkage = \"{linkage}\"\nunit = \"m\"\nvehicle = {{ wheel_radius = 0.3 }}\ntime = {{ instants = [0.0] }}\n\
             drives = {{ {drives} }}\n"
        );
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let sweep = ["sweep", "a.toml", "--drive", "bump_left=0", "--csv", "-"];
        let output = run(folder.path(), &sweep);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        text(&output.stdout)
            .lines()
            .next()
            .expect("a header")
            .to_owned()
    };
    let beam = names("twist_beam", "bump_left = 0.29, bump_right = 0.29");
    let steered = names(
        "steered_axle",
        "bump_left = 0.3, bump_right = 0.3, steer = 0.34",
    );
    for own in ["left_roll_centre_m", "right_jacking_percent"] {
        assert!(!beam.contains(own) && steered.contains(own), "{own}");
    }
    assert!(beam.contains("axle_roll_centre_z"), "{beam}");
}

/// As on a motorcycle: there is no opposite wheel, and no inboard side.
#[test]
fn a_wheel_on_the_centre_line_has_no_roll_centre() {
    let arm = |y: f64| {
        let at = |x: f64, off: f64, z: f64| format!("[{x:?}, {:?}, {z:?}]", y + off);
        let statements = format!(
            "fixed: near at {}, far at {};\nfree: hub at {};\nhinge arm: near, far -> hub;\n\
             point axle: arm at {};\ndrive bump: hub.z;\nwheel: axle -> hub;",
            at(0.5, 0.1, 0.35),
            at(0.5, -0.1, 0.35),
            at(0.0, 0.0, 0.3),
            at(0.0, -0.1, 0.3),
        );
        let file = format!(
            "unit = \"m\"\nstatements = '''\n{statements}\n'''\nvehicle = {{ wheel_radius = 0.3 }}\n\
             time = {{ instants = [0.0] }}\ndrives = {{ bump = 0.3 }}\n"
        );
        table(&file, &["motion"]).remove(0)
    };
    let (middle, beside) = (arm(0.0), arm(0.6));
    assert!(beside.contains_key("roll_centre_m") && !middle.contains_key("roll_centre_m"));
    // The slope of the contact point's path is still jacking.
    assert!(middle.contains_key("jacking_percent") && middle.contains_key("side_arm_m"));
    assert_eq!(middle.len() + 1, beside.len());
}
