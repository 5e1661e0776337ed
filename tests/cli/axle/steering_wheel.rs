//! The steering wheel: its angle, and the overall steering ratio.

use std::f64::consts::TAU;

use super::super::corner;
use super::{DESIGN, Row, assert_near, file, folder, run, table, text};

/// C-factor, m.
const PER_TURN: f64 = 0.052;

/// A step of the rack for which differences show the ratio, m.
const STEP: f64 = 1e-4;

/// A corner with its points in other axes and another unit.
struct Corner {
    header: &'static str,
    signs: [f64; 3],
    /// Units in a metre.
    metre: f64,
}

impl Corner {
    /// The rows of a sweep of the rack about the design position, 20 mm to either side, each between two others `STEP` away.
    fn swept(&self) -> Vec<[Row; 3]> {
        let points = corner::POINTS.map(|(name, at)| {
            let at = [0, 1, 2].map(|axis| at[axis] * self.signs[axis] * self.metre);
            format!("{name} = {at:?}\n")
        });
        let [_, y, z] = self.signs;
        let motion = format!(
            "linkage = \"double_wishbone\"\n{}\n[points]\n{}[vehicle]\nrack_per_turn = {}\n[time]\ninstants = [0.0]\n\
             [drives]\nbump = {:?}\nsteer = {:?}\n",
            self.header,
            points.concat(),
            PER_TURN * self.metre,
            0.30 * z * self.metre,
            0.34 * y * self.metre
        );
        swept(&motion, self.metre)
    }
}

fn swept(motion: &str, metre: f64) -> Vec<[Row; 3]> {
    let at = |rack: f64| {
        let row = |rack: f64| {
            let drive = format!("--drive=steer={:?}", rack * metre);
            let mut rows = table(motion, &["sweep", &drive]);
            rows.pop().expect("a row")
        };
        [rack - STEP, rack, rack + STEP].map(row)
    };
    [-0.02, 0.0, 0.015].map(at).into()
}

/// Holds the ratio against the differences of both angles over the rack; `to_the_left` is the sign of toe that points left.
pub(super) fn check(rows: &[Row; 3], names: [&str; 3], to_the_left: f64) {
    let [angle, toe, ratio] = names;
    let [before, now, after] = rows;
    let turned = after[angle] - before[angle];
    let steered = (after[toe] - before[toe]) * to_the_left;
    assert!(now[ratio] > 5.0, "{ratio}: {}", now[ratio]);
    assert_near(now[ratio], turned / steered, 1e-4 * now[ratio], ratio);
    assert!(turned * steered > 0.0, "{angle} and {toe} turn one way");
}

#[test]
fn the_steering_ratio_agrees_with_differences_over_the_rack() {
    let vehicle = format!("rack_per_turn = {PER_TURN}");
    let places = swept(&file("steered_axle", &vehicle, DESIGN), 1.0);
    let angle = "steering_wheel_angle_rad";
    for (rows, rack) in places.iter().zip([-0.02, 0.0, 0.015]) {
        assert_near(rows[1][angle], TAU * rack / PER_TURN, 1e-12, "turns");
        for (side, to_the_left) in [("left", -1.0), ("right", 1.0)] {
            let toe = format!("{side}_toe_rad");
            let ratio = format!("{side}_steering_ratio_rad_rad");
            check(rows, [angle, &toe, &ratio], to_the_left);
        }
    }
}

/// The side does not depend on the rack's position ahead of or behind the axle, nor on the sign of its drive.
#[test]
fn the_steering_wheel_and_the_road_wheels_turn_to_the_same_side() {
    let left = Corner {
        header: "unit = \"m\"",
        signs: [1.0; 3],
        metre: 1.0,
    };
    let right = Corner {
        header: "unit = \"mm\"\nangle = \"deg\"",
        signs: [1.0, -1.0, 1.0],
        metre: 1e3,
    };
    let in_sae = Corner {
        header: "unit = \"m\"\naxes = \"SAE\"",
        signs: [1.0, -1.0, -1.0],
        metre: 1.0,
    };
    let behind = Corner {
        header: "unit = \"m\"",
        signs: [-1.0, 1.0, 1.0],
        metre: 1.0,
    };
    let radians = [
        "steering_wheel_angle_rad",
        "toe_rad",
        "steering_ratio_rad_rad",
    ];
    let degrees = [
        "steering_wheel_angle_deg",
        "toe_deg",
        "steering_ratio_deg_deg",
    ];
    let turns = |corner: &Corner, names: [&str; 3], to_the_left: f64, of_rack: f64| {
        let places = corner.swept();
        for rows in &places {
            check(rows, names, to_the_left);
        }
        let [angle, _, ratio] = names;
        assert_eq!(places[1][1][angle].abs(), 0.0, "at the design position");
        let turn = if angle.ends_with("_deg") { 360.0 } else { TAU };
        let expected = of_rack * turn * 0.015 / PER_TURN;
        assert_near(places[2][1][angle], expected, 1e-9, angle);
        places[1][1][ratio]
    };
    let of_left = turns(&left, radians, -1.0, 1.0);
    let of_right = turns(&right, degrees, 1.0, 1.0);
    assert_near(of_right, of_left, 1e-9, "of the mirror image");
    let of_sae = turns(&in_sae, radians, -1.0, -1.0);
    assert_near(of_sae, of_left, 1e-9, "in SAE axes");
    let of_behind = turns(&behind, radians, -1.0, -1.0);
    assert_near(of_behind, of_left, 1e-9, "of a rack behind the axle");
}

/// A rear wheel that the same rack would not turn has no ratio, though it has the drive of the file.
#[test]
fn only_wheels_turned_by_the_rack_have_a_steering_ratio() {
    let drives = "front_bump_left = 0.3\nfront_bump_right = 0.3\nfront_steer = 0.34\n\
                  rear_bump_left = 0.29\nrear_bump_right = 0.29";
    let vehicle = format!("steer = \"front_steer\"\nrack_per_turn = {PER_TURN}");
    let motion = file("front_and_rear_axle", &vehicle, drives);
    let row = table(&motion, &["sweep", "--drive=front_steer=0.01"]).remove(0);
    let found = row
        .keys()
        .filter(|name| name.contains("steering_") && !name.contains("_per_"));
    let found: Vec<&str> = found.map(String::as_str).collect();
    assert_eq!(
        found,
        [
            "front_left_steering_ratio_rad_rad",
            "front_right_steering_ratio_rad_rad",
            "steering_wheel_angle_rad",
        ]
    );
}

#[test]
fn rack_per_turn_in_another_unit_is_noted() {
    for (travel, expected) in [
        ("52.0", "52 m: is it in mm? The file is in m"),
        (
            "0.005",
            "0.005 m: it is usually from 0.01 m to 0.5 m; is the number right?",
        ),
    ] {
        let motion = file("steered_axle", &format!("rack_per_turn = {travel}"), DESIGN);
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), motion).expect("written");
        let output = run(folder.path(), &["motion", "a.toml"]);
        let expected = format!("note: a.toml: rack_per_turn is {expected}\n");
        assert_eq!(text(&output.stderr), expected);
    }
}

#[test]
fn a_steering_ratio_is_tuned() {
    let motion = format!(
        "{}[tune.moves.tie_ball]\npoints = [\"tie_ball\"]\nalong = \"x\"\nby = [-0.02, 0.02]\n\
         [tune.targets.ratio]\nof = \"steering_ratio\"\nvalue = 15.0\nwithin = 0.001\n",
        file(
            "double_wishbone",
            &format!("rack_per_turn = {PER_TURN}"),
            "bump = 0.3\nsteer = 0.34"
        )
    );
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), motion).expect("written");
    let output = run(folder.path(), &["tune", "a.toml", "--out", "tuned.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let tuned = std::fs::read_to_string(folder.path().join("tuned.toml")).expect("a file");
    let row = table(&tuned, &["motion"]).remove(1);
    assert_near(row["steering_ratio_rad_rad"], 15.0, 1.1e-3, "ratio");
}

#[test]
fn an_invalid_rack_per_turn_is_refused() {
    let steered = |vehicle: &str| file("steered_axle", vehicle, DESIGN);
    let vehicle = "[vehicle]\nsteer = \"theta\"\nrack_per_turn = 52.0\n[time]";
    let turned_about_an_axis =
        include_str!("../../../examples/five_link.toml").replace("[time]", vehicle);
    let beam = "bump_left = 0.29\nbump_right = 0.29";
    let size = "rack_per_turn is not a positive finite number; give it in the unit of the file";
    for (motion, expected) in [
        (steered("rack_per_turn = 0.0"), size),
        (steered("rack_per_turn = -0.052"), size),
        (steered("rack_per_turn = inf"), size),
        (
            file("twist_beam", "rack_per_turn = 0.052", beam),
            "rack_per_turn needs a drive that steers a wheel, and no known drive of steering does; write steer = \"NAME\" under [vehicle] with \
             the name of one that does, or leave rack_per_turn out",
        ),
        (
            turned_about_an_axis,
            "rack_per_turn is the travel of a rack, but the drive that steers, `theta`, is an angle; leave rack_per_turn out and write steering_box_ratio, \
             the steering wheel's angle per angle of the drive, for example 16.0",
        ),
        (
            steered("steering_box_ratio = 16.0"),
            "steering_box_ratio is for a drive that is an angle, but the drive that steers, `steer`, is not; leave steering_box_ratio out and write rack_per_turn, \
             the drive's travel per turn of the steering wheel",
        ),
        (
            steered("steering_box_ratio = 0.0"),
            "steering_box_ratio is for a drive that is an angle, but the drive that steers, `steer`, is not; leave steering_box_ratio out and write rack_per_turn, \
             the drive's travel per turn of the steering wheel",
        ),
        (
            steered("steer = { left = \"steer\", right = \"bump_right\" }\nrack_per_turn = 0.052"),
            "rack_per_turn needs one drive of steering, but `steer` and `bump_right` steer the wheels; leave rack_per_turn out",
        ),
        (
            steered("").replace(
                "[vehicle]",
                "[vehicle]\n[design]\nrack_per_turn = 0.052\n[tolerances]",
            ),
            "rack_per_turn belongs under [vehicle]",
        ),
        (
            format!("steering_box_ratio = 16.0\n{}", steered("")),
            "steering_box_ratio belongs under [vehicle]",
        ),
    ] {
        check_refused(motion, expected);
    }
}

/// Holds that a motion file is refused with a sentence.
pub(super) fn check_refused(motion: String, expected: &str) {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), motion).expect("written");
    let output = run(folder.path(), &["motion", "a.toml"]);
    let messages = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{messages}");
    assert!(messages.contains(expected), "{messages}");
}

/// The tie rod is perpendicular to the path of its ball, so that the rack does not move it at first. The message says that
/// the design is singular; it does not ask for another drive of steering.
#[test]
fn a_tie_rod_that_locks_at_the_design_is_reported_as_singular() {
    let folder = folder();
    let file = "statements = '''
fixed: low at [0.0, 0.7, 0.2], high at [0.0, 0.7, 0.45], rack at [0.0, 0.3, 0.3];
free: ball at [0.0, 0.6, 0.3], wheel_centre at [0.0, 0.8, 0.3];
hinge knuckle: low, high -> ball, wheel_centre;
point hub: knuckle at [0.0, 0.75, 0.3];
link tie_rod: rack -> ball;
drive steer: rack.y;
wheel: hub -> wheel_centre;
'''
unit = \"m\"
vehicle = { rack_per_turn = 0.05 }
time = { instants = [0.0] }
drives = { steer = 0.3 }
";
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["check", "a.toml"]);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let messages = text(&output.stderr);
    assert!(
        messages.contains("the design position is singular"),
        "{messages}"
    );
}
