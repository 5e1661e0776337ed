//! The part of a car's load transfer in braking and driving that the links bear.

use super::program::{folder, rows, run, text};

/// A trailing arm, whose wheel turns about its pivot: 0.42 m ahead of the wheel centre and of the contact point, 0.30 m
/// above the ground, 0.01 m above the wheel centre.
fn file(vehicle: &str) -> String {
    format!(
        "linkage = \"trailing_arm\"\nunit = \"m\"\n[vehicle]\nwheel_radius = 0.29\n{vehicle}\n\
         [time]\ninstants = [0.0]\n[drives]\nbump = 0.29\n"
    )
}

const CAR: &str = "wheelbase = 2.5\ncg_height = 0.5\nbrake_share = 0.4\ndrive_share = 0.5\n";

#[test]
fn anti_lift_of_a_trailing_arm_is_the_slope_to_its_pivot() {
    let folder = folder();
    let path = folder.path().join("rear.toml");
    std::fs::write(path, file(&format!("axle = \"rear\"\n{CAR}"))).expect("written");
    let arguments = [
        "sweep",
        "rear.toml",
        "--drive",
        "bump=-0.002:0.002:5",
        "--csv",
        "-",
    ];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let table = rows(&output.stdout);
    let design = &table[2];
    let lift = 100.0 * 0.30 / 0.42 * 0.4 * 2.5 / 0.5;
    let squat = 100.0 * 0.01 / 0.42 * 0.5 * 2.5 / 0.5;
    assert!(
        (design["anti_lift_percent"] - lift).abs() < 1e-10,
        "{design:?}"
    );
    assert!(
        (design["anti_squat_percent"] - squat).abs() < 1e-10,
        "{design:?}"
    );
    assert!(!design.contains_key("anti_dive_percent"));
    // The arm turns about a line along y: from the front its carrier does not turn at all.
    for parallel in [
        "front_centre_y",
        "front_centre_z",
        "front_arm_m",
        "front_arm_m_per_bump",
    ] {
        assert!(
            design[parallel].is_nan(),
            "{parallel}: {}",
            design[parallel]
        );
    }
    assert!((design["side_arm_m"].abs() - 0.42).abs() < 1e-12);
    let [before, after] = [1, 3].map(|place: usize| table[place]["anti_lift_percent"]);
    let slope = (after - before) / 0.002;
    let per_bump = design["anti_lift_percent_per_bump"];
    assert!((per_bump / slope - 1.0).abs() < 1e-4, "{per_bump} {slope}");
}

/// Returns the values at the design position of an axle whose wheels move each other.
fn design_values_of_axle(
    linkage: &str,
    vehicle: &str,
) -> (std::collections::HashMap<String, f64>, String) {
    let folder = folder();
    let path = folder.path().join("rear.toml");
    let file = format!(
        "linkage = \"{linkage}\"\nunit = \"m\"\n[vehicle]\naxle = \"rear\"\n{CAR}{vehicle}\n\
         [time]\ninstants = [0.0]\n[drives]\nbump_left = 0.31\nbump_right = 0.31\n"
    );
    std::fs::write(path, file).expect("written");
    let drive = "bump_left=-0.001:0.001:3";
    let output = run(
        folder.path(),
        &["sweep", "rear.toml", "--drive", drive, "--csv", "-"],
    );
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let [_, design, _] = rows(&output.stdout).try_into().expect("three rows");
    (
        design.into_iter().collect(),
        text(&output.stderr).to_owned(),
    )
}

/// Brakes and drive load both wheels of an axle, so that it moves up and down as a whole: in the side view a twist beam
/// turns about its bushes, a live axle about the point where its links meet.
#[test]
fn support_angles_of_coupled_wheels_are_those_of_heave() {
    let (design, notes) = design_values_of_axle("twist_beam", "wheel_radius = 0.29");
    assert!(
        notes.contains("the chassis is assumed to bear the torque of the drive, through shafts"),
        "{notes}"
    );
    // A bush is 0.46 m ahead of the contact point and 0.30 m above it.
    let lift = 100.0 * 0.30 / 0.46 * 0.4 * 2.5 / 0.5;
    let found = design["left_anti_lift_percent"];
    assert!((found - lift).abs() < 1e-10, "{found} {lift}");
    // The shafts of a twist beam come from the chassis: 0.01 m from the wheel centre up to the bush.
    let squat = 100.0 * 0.01 / 0.46 * 0.5 * 2.5 / 0.5;
    let found = design["left_anti_squat_percent"];
    assert!((found - squat).abs() < 1e-10, "{found} {squat}");

    // Links of a live axle in the side view: lower from (0.56, 0.29) to (0.02, 0.24), upper from (0.34, 0.44) to
    // (0.02, 0.43), metres.
    let (lower, upper) = (0.05 / 0.54, 0.01 / 0.32);
    let x = (0.43 - 0.24 + 0.02 * (lower - upper)) / (lower - upper);
    let z = 0.24 + lower * (x - 0.02);
    for (torque, height, is_noted) in [
        ("", z, true),
        ("drive_torque = \"carrier\"\n", z, false),
        ("drive_torque = \"chassis\"\n", z - 0.31, false),
    ] {
        let (design, notes) = design_values_of_axle(
            "live_axle_splayed",
            &format!("wheel_radius = 0.31\n{torque}"),
        );
        let [lift, squat] = [z * 0.4, height * 0.5].map(|share| 100.0 * share / x * 2.5 / 0.5);
        for side in ["left", "right"] {
            let [found_lift, found_squat] =
                ["lift", "squat"].map(|of| design[&format!("{side}_anti_{of}_percent")]);
            assert!((found_lift - lift).abs() < 1e-9, "{found_lift} {lift}");
            assert!((found_squat - squat).abs() < 1e-9, "{found_squat} {squat}");
            let arm = design[&format!("{side}_side_arm_m")];
            assert!((arm + x).abs() < 1e-9, "{arm} {x}");
        }
        assert_eq!(notes.contains("de Dion"), is_noted, "{notes}");
    }
}

#[test]
fn an_incomplete_vehicle_is_refused_with_the_missing_entry() {
    for (vehicle, expected) in [
        (CAR, "axle = \"front\" or \"rear\" is missing"),
        (
            "axle = \"rear\"\nwheelbase = 2.5\nbrake_share = 0.4\n",
            "cg_height is missing",
        ),
        ("axle = \"rear\"\ncg_height = 0.5\n", "wheelbase is missing"),
        ("axle = \"middle\"\n", "unknown word `middle`"),
        (
            "brake_share = 60\n",
            "brake_share must be the axle's share of the force, from 0 to 1",
        ),
        ("brake_torque = \"hub\"\n", "\"carrier\" or \"chassis\""),
    ] {
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), file(vehicle)).expect("written");
        let output = run(folder.path(), &["sheet", "a.toml"]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let message = text(&output.stderr);
        assert_eq!(message.lines().count(), 1, "{message}");
        assert!(message.contains(expected), "{message}");
    }
}

/// The change of wheelbase needs only the name of the axle.
#[test]
fn wheelbase_change_needs_only_the_name_of_the_axle() {
    let slope = |axle: &str| {
        let folder = folder();
        let vehicle = format!("axle = \"{axle}\"\n");
        std::fs::write(folder.path().join("a.toml"), file(&vehicle)).expect("written");
        let output = run(
            folder.path(),
            &["sweep", "a.toml", "--drive=bump=0.0", "--csv", "-"],
        );
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        rows(&output.stdout)[0]["wheelbase_change_m_per_bump"]
    };
    let [front, rear] = ["front", "rear"].map(slope);
    assert!(front == -rear && front != 0.0, "{front} {rear}");
}

/// Dual wheels on an oblique arm, both left: each has the values of a single wheel on the arm, and they are not a live axle,
/// whose body would bear the drive's torque.
#[test]
fn dual_wheels_on_one_side_are_not_an_axle() {
    let listing = |wheels: &str| {
        format!(
            "unit = \"m\"\nstatements = '''\nfixed: outer at [0.3, 0.5, 0.32], inner at [0.2, 0.2, 0.30];\nfree: hub at [0.0, 0.6, 0.3];\n\
             hinge arm: outer, inner -> hub;\npoint axle: arm at [0.0, 0.45, 0.3];\npoint near: arm at [0.0, 0.55, 0.3];\n\
             point far: arm at [0.0, 0.8, 0.3];\n{wheels}\ndrive bump: hub.z;\n'''\n\
             vehicle = {{ wheel_radius = 0.3, axle = \"rear\", wheelbase = 2.5, cg_height = 0.5, brake_share = 0.4, drive_share = 0.5 }}\n\
             time = {{ instants = [0.0] }}\ndrives = {{ bump = 0.3 }}\n"
        )
    };
    let read = |wheels: &str| {
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), listing(wheels)).expect("written");
        let output = run(
            folder.path(),
            &["sweep", "a.toml", "--drive", "bump=0.02", "--csv", "-"],
        );
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let notes = text(&output.stderr).to_owned();
        (rows(&output.stdout).remove(0), notes)
    };
    let (dual, notes) = read("wheel near: axle -> near;\nwheel far: axle -> far;");
    assert_eq!(notes, "");
    for absent in ["track_m", "total_toe_rad"] {
        assert!(!dual.contains_key(absent), "{absent}");
    }
    let mut count = 0;
    for name in ["near", "far"] {
        let (alone, _) = read(&format!("wheel: axle -> {name};"));
        let of_wheel = alone.iter().filter_map(|(column, expected)| {
            let found = dual.get(&format!("{name}_{column}"))?;
            Some((column, found, expected))
        });
        for (column, found, expected) in of_wheel {
            let is_same = (found - expected).abs() < 1e-12 || found.is_nan() && expected.is_nan();
            assert!(is_same, "{name} {column}: {found} {expected}");
            count += usize::from(found.is_finite());
        }
    }
    for known in ["near_front_centre_z", "far_anti_squat_percent"] {
        assert!(dual[known].is_finite(), "{known}");
    }
    assert!(count > 30, "{count}");
}

/// A car with a third axle: the quantities are of the front and the rear one.
#[test]
fn a_share_of_a_third_axle_is_noted() {
    let axles = ["front", "rear", "third"];
    let arms = [("front", 0.0), ("rear", -2.6), ("third", -3.6)].map(|(axle, x)| {
        let ahead = x + 0.3;
        format!(
            "fixed: {axle}_left_a at [{ahead:?}, 0.5, 0.4], {axle}_left_b at [{ahead:?}, 0.3, 0.4];\n\
             free: {axle}_left_hub at [{x:?}, 0.7, 0.3];\n\
             hinge {axle}_left_arm: {axle}_left_a, {axle}_left_b -> {axle}_left_hub;\n\
             point {axle}_left_axle: {axle}_left_arm at [{x:?}, 0.6, 0.3];\n\
             drive {axle}_left_bump: {axle}_left_hub.z;\nwheel {axle}_left: {axle}_left_axle -> {axle}_left_hub;\n"
        )
    });
    let sides = ["left", "right"];
    let drives = axles.map(|axle| {
        sides
            .map(|side| format!("{axle}_{side}_bump = 0.3\n"))
            .concat()
    });
    let file = format!(
        "unit = \"m\"\nstatements = \"\"\"\nmirror: left -> right;\n{}\"\"\"\n[vehicle]\nwheelbase = 2.6\ncg_height = 0.5\n\
         brake_share = {{ front = 0.5, third = 0.2 }}\n[time]\ninstants = [0.0]\n[drives]\n{}",
        arms.concat(),
        drives.concat()
    );
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["check", "a.toml"]);
    let expected = "anti-dive, anti-lift and anti-squat are left out for `third_left` and `third_right`, whose share of the force has no \
                    effect: they are quantities of wheels that have `front` or `rear` in their names\n";
    assert!(text(&output.stdout).contains(expected), "{output:?}");
}
