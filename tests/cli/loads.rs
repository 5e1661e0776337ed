//! Forces under load cases.

mod acting;
mod cases;
mod drawings;
mod measures;
mod moments;
mod moments_of_measures;
mod moments_of_statements;
mod on_chassis;
mod places;
mod shared_points;
mod springs;
mod unloaded;

use std::collections::BTreeMap;

use nalgebra::Vector3;

use super::program::{self, CORNER, Rows, folder, run, text};

/// The corner with load cases of a wheel that brakes and corners.
fn loaded(cases: &str) -> String {
    format!("{CORNER}{cases}")
}

const BRAKING: &str = "[loads.braking]\ncontact = [-3000.0, 200.0, 4000.0]\n";

pub(super) fn table(file: &str, more: &[&str]) -> Rows {
    program::table(file, &[&["loads"], more].concat())
}

pub(super) fn force(row: &BTreeMap<String, f64>, name: &str) -> Vector3<f64> {
    Vector3::from(["x", "y", "z"].map(|axis| row[&format!("{name}_{axis}_N")]))
}

pub(super) fn swept(file: &str, more: &[&str]) -> Rows {
    program::table(file, &[&["sweep"], more].concat())
}

const GRID: [&str; 4] = [
    "--drive",
    "bump=-0.05:0.05:5",
    "--drive",
    "steer=-0.02:0.02:3",
];

/// The shares of two bushes in the force along their line are not determined: each bears half, in any order of the points,
/// for a `hinge` as for a `body` with two chassis points. An arm with its bushes 0.3 m before and behind its tip and a force of 1000 N forwards there, 0.45 m outboard.
#[test]
fn bushes_of_a_hinge_share_the_axial_force_equally() {
    for arm in [
        "hinge arm: front, rear -> tip, hub",
        "hinge arm: front, rear -> hub, tip",
        "body arm: front, rear, tip, hub",
        "body arm: front, rear, hub, tip",
    ] {
        let file = format!(
            "unit = \"m\"\nstatements = \"\"\"\nfixed: front at [0.3, 0.3, 0.2], rear at [-0.3, 0.3, 0.2];\n\
             free: tip at [0.0, 0.75, 0.2], hub at [0.2, 0.5, 0.25];\n{arm};\n\
             drive bump: tip.z;\n\"\"\"\ntime = {{ instants = [0.0] }}\ndrives = {{ bump = 0.2 }}\n\
             [loads.a]\ntip = [1000.0, 0.0, 0.0]\n"
        );
        let row = &table(&file, &[])[0];
        for (bush, expected) in [
            ("front", [500.0, -750.0, 0.0]),
            ("rear", [500.0, 750.0, 0.0]),
        ] {
            let found = force(row, &format!("a_arm_{bush}"));
            assert!(
                (found - Vector3::from(expected)).amax() < 1e-9,
                "{arm}, {bush}: {found}"
            );
        }
    }
}

/// The upright as a free body: the forces at its joints equal the load at the contact point, and their moments cancel.
#[test]
fn joint_forces_of_the_upright_balance_the_load_at_the_contact_point() {
    let file = loaded(&format!("{BRAKING}bump = \"damper\"\n"));
    let load = Vector3::new(-3000.0, 200.0, 4000.0);
    let (loads, places) = (table(&file, &GRID), swept(&file, &GRID));
    assert_eq!((loads.len(), places.len()), (15, 15));
    for (row, place) in loads.iter().zip(&places) {
        let at = |point: &str| {
            Vector3::from(["x", "y", "z"].map(|axis| place[&format!("{point}_{axis}")]))
        };
        let joints = ["lower_ball", "upper_ball", "tie_ball", "wheel_centre"];
        let forces = joints.map(|joint| force(row, &format!("braking_upright_{joint}")));
        let sum: Vector3<f64> = forces.iter().sum();
        assert!((sum - load).norm() < 1e-8, "{sum}");
        let about_contact = joints.iter().zip(forces);
        let moments = about_contact.map(|(joint, force)| (at(joint) - at("contact")).cross(&force));
        let moment: Vector3<f64> = moments.sum();
        assert!(moment.norm() < 1e-8, "{moment}");
        assert!(row["braking_bump_N"].abs() < 1e-8, "the damper bears it");
        assert!(
            forces[3].norm() < 1e-8,
            "nothing else joins the wheel centre"
        );
        let link = (at("lower_ball") - at("upper_ball")).norm();
        assert!(link > 0.1, "places have the same order");
    }
}

/// Virtual work: the spring's force times its motion ratio is the force that the drive would bear without it.
#[test]
fn spring_force_is_the_wheel_load_over_the_motion_ratio() {
    let without = table(&loaded(BRAKING), &GRID);
    let with = table(&loaded(&format!("{BRAKING}bump = \"damper\"\n")), &GRID);
    let places = swept(&loaded(BRAKING), &GRID);
    for ((without, with), place) in without.iter().zip(&with).zip(&places) {
        let ratio = place["damper_m_per_bump"];
        let expected = -without["braking_bump_N"] / ratio;
        let found = with["braking_damper_N"];
        assert!(
            (found - expected).abs() < 1e-9 * expected.abs(),
            "{found} {expected}"
        );
        assert!(found > 1000.0, "a compressed spring pushes its ends apart");
    }
}

/// The spring's force may be stated: then the drive bears the rest.
#[test]
fn a_stated_spring_force_reduces_the_force_on_the_drive() {
    let case = "[loads.half]\ncontact = [0.0, 0.0, 4000.0]\ndamper = 2000.0\n";
    let row = &table(&loaded(case), &[])[0];
    let place = &swept(&loaded(case), &["--drive", "bump=0.0"])[0];
    let alone = &table(&loaded("[loads.half]\ncontact = [0.0, 0.0, 4000.0]\n"), &[])[0];
    let expected = alone["half_bump_N"] + 2000.0 * place["damper_m_per_bump"];
    assert!((row["half_bump_N"] - expected).abs() < 1e-9);
}

/// Millimetres, and the axes of Adams, are the same corner: forces turn with the axes.
#[test]
fn loads_do_not_depend_on_units_and_axes() {
    let expected = &table(&loaded(BRAKING), &[])[0];
    let turned = loaded(&BRAKING.replace("[-3000.0, 200.0, 4000.0]", "[3000.0, -200.0, 4000.0]"));
    let turned = turned
        .replace("unit = \"m\"", "unit = \"m\"\naxes = \"Adams\"")
        .replace("steer = 0.34", "steer = -0.34");
    let found = &table(&turned, &[])[0];
    for (name, value) in expected.iter().filter(|(name, _)| name.ends_with("_N")) {
        let sign =
            match name.ends_with("_x_N") || name.ends_with("_y_N") || name.ends_with("steer_N") {
                true => -1.0,
                false => 1.0,
            };
        assert!(
            (found[name] - sign * value).abs() < 1e-8,
            "{name}: {} {value}",
            found[name]
        );
    }
    let five_link = include_str!("../../examples/five_link.toml");
    let in_millimetres =
        format!("{five_link}\n[loads.weight]\nwheel_centre = [0.0, 0.0, 3000.0]\n");
    let row = &table(&in_millimetres, &["--drive", "theta=0.0:0.4:3"])[0];
    let place = &swept(&in_millimetres, &["--drive", "theta=0.0:0.4:3"])[0];
    let expected = 3000.0 * place["wheel_centre_z_per_theta"] / 1000.0;
    assert!(
        (row["weight_theta_Nm"] - expected).abs() < 1e-9 * expected.abs(),
        "{row:?}"
    );
}

/// A moment at a body is the same as a couple of forces at two of its points.
#[test]
fn a_moment_on_a_body_equals_a_couple_of_forces() {
    let place = &swept(CORNER, &["--drive", "bump=0.0"])[0];
    let at =
        |point: &str| Vector3::from(["x", "y", "z"].map(|axis| place[&format!("{point}_{axis}")]));
    let force = Vector3::new(700.0, -300.0, 0.0);
    let moment = (at("axle") - at("wheel_centre")).cross(&force);
    let written = |vector: Vector3<f64>| format!("{:?}", [vector.x, vector.y, vector.z]);
    let couple = format!(
        "[loads.a]\naxle = {}\nwheel_centre = {}\n",
        written(force),
        written(-force)
    );
    let couple = &table(&loaded(&couple), &[])[0];
    let alone = format!(
        "[loads.a]\nwheel_centre = {{ moment = {} }}\n",
        written(moment)
    );
    let alone = &table(&loaded(&alone), &[])[0];
    for name in couple
        .keys()
        .filter(|name| name.starts_with("a_") && !name.contains("_upright_wheel_centre_"))
    {
        assert!(
            (couple[name] - alone[name]).abs() < 1e-8,
            "{name}: {} {}",
            couple[name],
            alone[name]
        );
    }
}

#[test]
fn the_loads_report_has_each_table_for_each_case() {
    let folder = folder();
    let cases =
        format!("{BRAKING}bump = \"damper\"\n[loads.cornering]\ncontact = [0.0, 3500.0, 5000.0]\n");
    std::fs::write(folder.path().join("a.toml"), loaded(&cases)).expect("written");
    let output = run(folder.path(), &["loads", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report = text(&output.stdout);
    for expected in [
        "a.toml: load case braking at bump = 0.3 m, steer = 0.34 m; axes of ISO 8855",
        "a.toml: load case cornering",
        "drive  bears\n",
        "measure  bears (positive: towards a larger value)\n",
        "link     tension\n",
        "exerts along x, y and z\n",
        "upright at lower_ball",
    ] {
        assert!(report.contains(expected), "{expected}: {report}");
    }
    let output = run(
        folder.path(),
        &["loads", "a.toml", "--drive", "bump=-0.05:0.05:5"],
    );
    assert!(text(&output.stdout).contains("least and greatest of 5 places"));
    assert!(folder.path().join("out/a_loads.csv").exists());
}

/// A driver at the rack: its drive bears the force along the way of the rack, and no link more.
#[test]
fn a_force_at_a_driven_chassis_point_is_borne_by_its_drive() {
    let case = |rack: &str| {
        let case = format!("[loads.a]\ncontact = [0.0, 500.0, 4000.0]\n{rack}");
        table(&loaded(&case), &[])[0].clone()
    };
    let [bare, pushed] = [case(""), case("rack = [300.0, 700.0, -200.0]\n")];
    let by = |name: &str| pushed[name] - bare[name];
    assert!(
        (by("a_steer_N") - 700.0).abs() < 1e-9,
        "{}",
        by("a_steer_N")
    );
    assert!(by("a_tie_rod_N").abs() < 1e-9, "{}", by("a_tie_rod_N"));
}

/// A marker of three points that are not rigid: the drives bear the work of its force, by the derivatives of its coordinates.
#[test]
fn a_force_at_a_marker_off_all_bodies_does_the_work_of_the_marker() {
    let file = "unit = \"m\"\ntime = { instants = [0.0] }\ndrives = { bump = 0.1, side = 0.2 }\nstatements = \"\"\"\n\
                fixed: front at [0.2, 0.0, 0.3], rear at [-0.2, 0.0, 0.3];\nfree: tip at [0.0, 0.4, 0.1];\nlink fore: front -> tip;\n\
                point seat: front, rear, tip at [0.0, 0.3, 0.1];\ndrive side: tip.x - rear.x;\ndrive bump: tip.z;\n\"\"\"\n\
                [loads.a]\nseat = [100.0, 200.0, 300.0]\n";
    let borne = &table(file, &[])[0];
    let seat = &swept(file, &["--drive", "bump=0:0.01:2"])[0];
    for drive in ["bump", "side"] {
        let per = |axis: &str| seat[&format!("seat_{axis}_per_{drive}")];
        let work = 100.0 * per("x") + 200.0 * per("y") + 300.0 * per("z");
        let borne = borne[&format!("a_{drive}_N")];
        assert!((borne - work).abs() < 1e-9, "{drive}: {borne}, {work}");
    }
}

/// The published five-point suspension locks at theta = 2.178426 rad.
#[test]
fn the_loads_report_warns_near_a_lock() {
    let file = include_str!("../../examples/attia2003.toml");
    let file = format!("{file}[loads.a]\np11 = [0.0, 0.0, 1000.0]\n");
    for (theta, is_near) in [("2.1", false), ("2.17842626", true)] {
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), &file).expect("written");
        let drive = format!("theta={theta}");
        let output = run(
            folder.path(),
            &["loads", "a.toml", "--absolute", "--drive", &drive],
        );
        let is_reported = text(&output.stdout).contains("is near a position where it locks");
        assert!(
            output.status.success() && is_reported == is_near,
            "{theta}: {output:?}"
        );
    }
}
