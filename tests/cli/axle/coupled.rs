//! Axles whose wheels move each other, and drives that move both wheels or neither.

use super::super::program::{folder, run, text};
use super::{assert_near, table};

/// A motion file with statements at its design position.
fn file(statements: &str, vehicle: &str, drives: &str) -> String {
    format!(
        "unit = \"m\"\nstatements = '''\n{statements}\n'''\n[vehicle]\nwheel_radius = 0.3\n{vehicle}\n\
         [time]\ninstants = [0.0]\n[drives]\n{drives}\n"
    )
}

/// The same, of a car.
const CAR: &str = "wheelbase = 2.6\ncg_height = 0.5\nbrake_share = 0.6\naxle = \"front\"";

/// Arms that rotate about transverse lines: contact points move vertically, so that the normals to their velocities are
/// horizontal.
fn trailing_arms(drives: &str) -> String {
    let statements = "mirror: left -> right;\nfixed: left_in at [0.5, 0.3, 0.3], left_out at [0.5, 0.6, 0.3];\n\
                      free: left_hub at [0.0, 0.7, 0.3];\nhinge left_arm: left_in, left_out -> left_hub;\n\
                      point left_axle: left_arm at [0.0, 0.6, 0.3];\ndrive bump_left: left_hub.z;\nwheel left: left_axle -> left_hub;";
    file(statements, "", drives)
}

#[test]
fn level_normals_put_the_roll_centre_on_the_ground_in_the_middle() {
    for height in [0.3, 0.35] {
        let drives = format!("bump_left = {height:?}\nbump_right = {height:?}");
        let row = &table(
            &trailing_arms(&drives),
            &["sweep", "--drive", "bump_left=0"],
        )[0];
        // The ground is where the wheels stand.
        let ground = 0.3 - 0.3;
        assert_near(row["axle_roll_centre_y"], 0.0, 1e-12, "y");
        assert_near(row["axle_roll_centre_z"], ground, 1e-12, "z");
        assert!(row["axle_roll_centre_z_per_bump_left"].is_nan());
    }
    // At different heights they do not meet.
    let raised = ["sweep", "--drive", "bump_left=0.02"];
    let row = &table(&trailing_arms("bump_left = 0.3\nbump_right = 0.3"), &raised)[0];
    assert!(row["axle_roll_centre_y"].is_nan() && row["axle_roll_centre_z"].is_nan());
}

/// The right arm steers the left knuckle; both arms turn about one line across the vehicle.
const ONE_WAY: &str = "\
fixed: left_in at [-0.6, 0.3, 0.4], left_out at [-0.6, 0.55, 0.4], right_in at [-0.6, -0.3, 0.4], right_out at [-0.6, -0.55, 0.4];
free: low at [0.0, 0.6, 0.2], top at [0.0, 0.58, 0.45], tie at [-0.16, 0.6, 0.3], left_hub at [0.0, 0.7, 0.3],
      right_hub at [0.0, -0.7, 0.3], rod_end at [-0.1, -0.4, 0.2];
hinge left_arm: left_in, left_out -> low, top;
body knuckle: low, top, tie, left_hub;
hinge right_arm: right_in, right_out -> right_hub, rod_end;
link rod: rod_end -> tie;
point left_axle: knuckle at [0.0, 0.6, 0.3];
point right_axle: right_arm at [0.0, -0.6, 0.3];
drive bump_left: left_hub.z;
drive bump_right: right_hub.z;
wheel left: left_axle -> left_hub;
wheel right: right_axle -> right_hub;";

#[test]
fn a_wheel_moved_one_way_by_another_has_quantities_in_heave() {
    let drives = "bump_left = 0.3\nbump_right = 0.3";
    let row = &table(&file(ONE_WAY, CAR, drives), &["motion"])[0];
    // Brakes on the carrier: the contact point turns about the line at a height of 0.4 m, 0.6 m behind the wheel.
    let expected = 100.0 * 0.6 * (2.6 / 0.5) * (0.4 / 0.6);
    for wheel in ["left", "right"] {
        let found = row[&format!("{wheel}_anti_dive_percent")];
        assert_near(found, expected, 1e-9, wheel);
    }
    // A force on the right wheel is borne only by its own links, one on the left wheel loads the spring of the right one.
    assert!(row.contains_key("right_roll_centre_m") && !row.contains_key("left_roll_centre_m"));
}

/// A rigid axle, driven by the heights of its wheels or by the lengths of its dampers.
fn rigid_axle(left: &str) -> String {
    format!(
        "mirror: left -> right;\nfixed: left_front at [0.6, 0.45, 0.25], above at [0.5, 0.05, 0.5], panhard_top at [-0.08, -0.45, 0.33],\n\
         left_damper_top at [-0.03, 0.4, 0.65];\nfree: left_rear at [0.06, 0.5, 0.24], middle at [0.1, 0.04, 0.44], \
         panhard_low at [-0.07, 0.44, 0.3],\nleft_damper_low at [0.0, 0.47, 0.22], left_hub at [0.0, 0.72, 0.3];\n\
         link left_trail: left_front -> left_rear;\nlink upper: above -> middle;\nlink panhard: panhard_top -> panhard_low;\n\
         body beam: left_rear, right_rear, middle, panhard_low, left_damper_low, right_damper_low, left_hub, right_hub;\n\
         point left_axle: beam at [0.0, 0.6, 0.3];\ndrive bump_left: {left};\nmeasure left_damper: length(left_damper_top -> left_damper_low);\n\
         wheel left: left_axle -> left_hub;"
    )
}

#[test]
fn instant_centres_do_not_depend_on_the_drives_of_an_axle() {
    let heights = rigid_axle("left_hub.z");
    let heights = file(&heights, "", "bump_left = 0.3\nbump_right = 0.3");
    let of_left = "length(left_damper_top -> left_damper_low)";
    let length = f64::hypot(f64::hypot(0.03, 0.07), 0.43);
    let dampers = rigid_axle(of_left);
    let dampers = file(
        &dampers,
        "",
        &format!("bump_left = {length:?}\nbump_right = {length:?}"),
    );
    let [by_height, by_damper] = [heights, dampers].map(|file| table(&file, &["motion"]).remove(0));
    for wheel in ["left", "right"] {
        for quantity in ["front_centre_y", "front_centre_z", "front_arm_m"] {
            let name = format!("{wheel}_{quantity}");
            assert_near(by_damper[&name], by_height[&name], 1e-9, &name);
        }
        // The other wheel's centre keeps its height: the beam turns about a line through it.
        assert_near(
            by_height[&format!("{wheel}_front_arm_m")],
            1.44,
            1e-9,
            wheel,
        );
    }
}

/// Two axles of which the front one is steered and driven by `bump`, the rear one driven by `lift`.
#[test]
fn a_usual_drive_name_is_not_the_travel_of_an_unmoved_wheel() {
    let arms = "fixed: a at [0.4, 0.3, 0.3], b at [0.4, 0.6, 0.3], c at [-2.2, 0.3, 0.3], d at [-2.2, 0.6, 0.3],\n\
                low at [0.0, 0.6, 0.2];\nfree: front_hub at [0.0, 0.7, 0.3], rear_hub at [-2.6, 0.7, 0.3], rack at [0.5, 0.0, 0.2];\n\
                hinge front_arm: a, b -> front_hub;\nhinge rear_arm: c, d -> rear_hub;\n\
                couple x: rack.x = low.x;\ncouple z: rack.z = low.z;\npoint front_in: front_arm at [0.0, 0.6, 0.3];\n\
                point rear_in: rear_arm at [-2.6, 0.6, 0.3];\ndrive bump: front_hub.z;\ndrive lift: rear_hub.z;\ndrive steer: rack.y;\n\
                wheel front_left: front_in -> front_hub;\nwheel rear_left: rear_in -> rear_hub;";
    let arms = arms.replace("rack at [0.5, 0.0, 0.2]", "rack at [0.0, 0.0, 0.2]");
    let drives = "bump = 0.3\nlift = 0.3\nsteer = 0.0";
    let has = |file: &str, name: &str| table(file, &["motion"])[0].contains_key(name);
    let alone = file(&arms, "", drives);
    assert!(!has(&alone, "front_left_virtual_kingpin_rad"));
    assert!(has(&alone, "front_left_brake_angle_rad") && !has(&alone, "rear_left_brake_angle_rad"));
    let stated = "travel = { front_left = \"bump\", rear_left = \"lift\" }";
    let stated = file(&arms, stated, drives);
    assert!(has(&stated, "rear_left_brake_angle_rad"));
    let folder = folder();
    for (content, is_noted) in [(&alone, true), (&stated, false)] {
        std::fs::write(folder.path().join("a.toml"), content).expect("written");
        let output = run(folder.path(), &["motion", "a.toml"]);
        let note = "the drive `bump` does not move the rear_left wheel up or down; write travel = { rear_left = \"NAME\" } under";
        assert_eq!(text(&output.stderr).contains(note), is_noted, "{output:?}");
    }
    // One wheel ahead of the other is no axle.
    let in_line = arms
        .replace("front_left", "front")
        .replace("rear_left", "rear");
    assert!(!has(&file(&in_line, "", drives), "track_m"));
}

/// Three arms one behind the other: the front and the rear arm have quantities of a car, the one between them has none.
#[test]
fn a_wheel_between_the_axles_has_no_quantities_of_an_axle() {
    let arm = |name: &str, x: f64| {
        format!(
            "fixed: {name}_in at [{:?}, 0.3, 0.35], {name}_out at [{:?}, 0.6, 0.35];\nfree: {name}_left_hub at [{x:?}, 0.7, 0.3];\n\
             hinge {name}_arm: {name}_in, {name}_out -> {name}_left_hub;\npoint {name}_axle: {name}_arm at [{x:?}, 0.6, 0.3];\n\
             drive {name}_left_bump: {name}_left_hub.z;\nwheel {name}_left: {name}_axle -> {name}_left_hub;\n",
            x + 0.5,
            x + 0.5
        )
    };
    let arms: Vec<String> = [("front", 0.0), ("mid", -2.0), ("rear", -3.2)]
        .map(|(name, x)| arm(name, x))
        .into();
    let vehicle =
        "wheelbase = 3.2\ncg_height = 0.8\nbrake_share = { front = 0.5, mid = 0.25, rear = 0.25 }";
    let drives = "front_left_bump = 0.3\nmid_left_bump = 0.3\nrear_left_bump = 0.3";
    let row = &table(&file(&arms.join(""), vehicle, drives), &["motion"])[0];
    for (name, is_there) in [
        ("front_left_anti_dive_percent", true),
        ("rear_left_anti_lift_percent", true),
        ("mid_left_anti_dive_percent", false),
        ("mid_left_anti_lift_percent", false),
    ] {
        assert_eq!(row.contains_key(name), is_there, "{name}");
    }
}
