//! Weight and inertia of the parts of a mechanism.

mod mistakes;

use nalgebra::{Matrix3, Vector3};

use super::loads::{force, swept, table};
use super::program::{self, Rows, folder, run};

/// A corner that moves up and down and steers, with masses and a load case.
fn corner(masses: &str, case: &str) -> String {
    format!(
        "linkage = \"double_wishbone_pushrod\"\nunit = \"m\"\ntime = {{ instants = [0.0, 0.02, 0.04] }}\n\
         [drives]\nbump = [0.28, 0.9, 2.5]\nsteer = [0.33, 0.4]\n[masses]\n{masses}\n[loads.a]\n{case}\n"
    )
}

/// Particles at points of the upright, and the equivalent body.
const PARTICLES: [(&str, f64); 4] = [
    ("lower_ball", 6.0),
    ("upper_ball", 4.0),
    ("tie_ball", 2.0),
    ("wheel_centre", 15.0),
];

fn particles() -> String {
    let each = PARTICLES.map(|(point, mass)| format!("{point} = {mass:?}"));
    each.join("\n")
}

/// Returns the equivalent body; points are those of the design.
fn as_body(design: impl Fn(&str) -> Vector3<f64>) -> String {
    let mass: f64 = PARTICLES.iter().map(|(_, mass)| mass).sum();
    let moments = PARTICLES.iter().map(|(point, mass)| design(point) * *mass);
    let centre = moments.sum::<Vector3<f64>>() / mass;
    let inertia = PARTICLES.iter().map(|(point, mass)| {
        let r = design(point) - centre;
        (Matrix3::from_diagonal_element(r.norm_squared()) - r * r.transpose()) * *mass
    });
    let i: Matrix3<f64> = inertia.sum();
    let inertia = [i.m11, i.m22, i.m33, i.m12, i.m23, i.m31];
    let centre = [centre.x, centre.y, centre.z];
    format!("upright = {{ mass = {mass:?}, centre = {centre:?}, inertia = {inertia:?} }}")
}

fn moved(file: &str) -> Rows {
    program::table(file, &["motion"])
}

fn design(point: &str) -> Vector3<f64> {
    let row = &swept(&corner("", ""), &["--drive", "bump=0.0"])[0];
    Vector3::from(["x", "y", "z"].map(|axis| row[&format!("{point}_{axis}")]))
}

/// Conservation of energy: without gravity the drives' power is the rate of the kinetic energy.
#[test]
fn power_of_the_drives_is_the_rate_of_kinetic_energy() {
    let file = corner(&particles(), "gravity = [0.0, 0.0, 0.0]");
    let (loads, states) = (table(&file, &["--motion"]), moved(&file));
    assert_eq!((loads.len(), states.len()), (3, 3));
    for (load, state) in loads.iter().zip(&states) {
        let vector = |point: &str, kind: &str| {
            Vector3::from(["x", "y", "z"].map(|axis| state[&format!("{point}_{kind}{axis}")]))
        };
        let rates =
            PARTICLES.map(|(point, mass)| mass * vector(point, "v").dot(&vector(point, "a")));
        let expected: f64 = rates.iter().sum();
        let t = state["t_s"];
        assert_eq!(load["t_s"], t);
        // The drives bear the forces of the masses, so they supply the opposite.
        let power = -load["a_bump_N"] * (0.9 + 5.0 * t) - load["a_steer_N"] * 0.4;
        assert!(
            (power - expected).abs() < 1e-9 * expected.abs(),
            "{power} {expected}"
        );
        assert!(expected.abs() > 10.0);
    }
}

/// A body is its particles: all loads are the same but those inside it.
#[test]
fn loads_of_a_body_equal_those_of_its_particles() {
    for more in [&["--motion"][..], &["--drive", "bump=-0.05:0.05:5"]] {
        let with = |masses: &str| table(&corner(masses, "acceleration = [-8.0, 3.0, 0.0]"), more);
        let (expected, found) = (with(&particles()), with(&as_body(design)));
        assert_eq!(expected.len(), found.len());
        for (expected, found) in expected.iter().zip(&found) {
            for (name, value) in expected
                .iter()
                .filter(|(name, _)| !name.contains("upright"))
            {
                let off = (found[name] - value).abs();
                assert!(off < 1e-7, "{name}: {off:e} of {value}");
            }
        }
    }
}

/// The effect of the wheel's weight, by virtual work; the upright passes it on.
#[test]
fn weight_of_masses_acts_in_every_load_case() {
    let file = corner(
        "upright = { mass = 30.0, centre = \"lower_ball\" }\ntie_rod = 1.2",
        "",
    );
    let row = &table(&file, &[])[0];
    let place = &swept(&file, &["--drive", "bump=0.0"])[0];
    let g = 9.806_65;
    let slope = |name: &str| place[&format!("{name}_z_per_bump")];
    // Bump does not move the rack.
    let rod = 1.2 * slope("tie_ball") / 2.0;
    let expected = -g * (30.0 * slope("lower_ball") + rod);
    assert!(
        (row["a_bump_N"] - expected).abs() < 1e-9 * expected.abs(),
        "{row:?}"
    );
    let joints = ["lower_ball", "upper_ball", "tie_ball", "wheel_centre"];
    let joints = joints.map(|joint| force(row, &format!("a_upright_{joint}")));
    let sum: Vector3<f64> = joints.iter().sum();
    assert!(
        (sum - Vector3::new(0.0, 0.0, -30.0 * g)).norm() < 1e-8,
        "{sum}"
    );
    let ends = ["rack", "tie_ball"].map(|end| force(row, &format!("a_tie_rod_{end}")));
    let sum: Vector3<f64> = ends.iter().sum();
    assert!(
        (sum - Vector3::new(0.0, 0.0, -1.2 * g)).norm() < 1e-9,
        "{sum}"
    );
}

/// A rack that is a chassis point, of 4 kg, in the direction of its drive: the drive bears its inertia, and no other part
/// does; its weight is borne by the housing, and travel does not move it.
#[test]
fn a_drive_bears_the_inertia_of_its_chassis_point() {
    let file = |masses: &str| {
        let file = corner(
            &format!("lower_ball = 3.0\n{masses}"),
            "wheel_centre = [0.0, 0.0, 0.0]",
        );
        file.replace("steer = [0.33, 0.4]", "steer = [0.33, 0.4, 3.0]")
    };
    let (with, without) = (file("rack = 4.0"), file(""));
    let rows = table(&with, &["--motion"]);
    for (with, without) in rows.iter().zip(&table(&without, &["--motion"])) {
        for (name, found) in with {
            let expected = match name.as_str() {
                "a_steer_N" => without[name] - 4.0 * 6.0,
                _ => without[name],
            };
            assert!(
                (found - expected).abs() < 1e-9,
                "{name}: {found} {expected}"
            );
        }
    }
    assert_eq!(rows.len(), 3);
    let mass = |file: &str| moved(file)[1]["effective_mass_kg"];
    assert!((mass(&with) - mass(&without)).abs() < 1e-12);
}

/// The same law in millimetres, for a drive that is an angle: moments are in N m.
#[test]
fn power_of_a_driven_angle_in_millimetres_is_kinetic_energy_rate() {
    let masses = "[masses]\nwheel_centre = 20.0\n[loads.a]\ngravity = [0.0, 0.0, 0.0]\n";
    let file = format!("{}{masses}", include_str!("../../examples/five_link.toml"));
    let (loads, states) = (table(&file, &["--motion"]), moved(&file));
    assert!(loads.len() == states.len() && loads.len() > 20);
    for (load, state) in loads.iter().zip(&states) {
        let vector = |kind: &str| {
            Vector3::from(
                ["x", "y", "z"].map(|axis| state[&format!("wheel_centre_{kind}{axis}")] / 1000.0),
            )
        };
        let expected = 20.0 * vector("v").dot(&vector("a"));
        let power = -load["a_theta_Nm"] * 0.6;
        assert!(
            (power - expected).abs() < 1e-8 * (1.0 + expected.abs()),
            "{power} {expected}"
        );
    }
}

/// A centre of mass that is stated by a point moves with it: tuning uses the same centre as the written file.
#[test]
fn a_centre_of_mass_stated_by_a_point_moves_with_the_point() {
    let file = "linkage = \"double_wishbone\"\nunit = \"m\"\nvehicle = { wheel_radius = 0.3 }\ntime = { instants = [0.0] }\n\
                [drives]\nbump = 0.3\nsteer = 0.34\n\
                [masses]\nupright = { mass = 20.0, centre = \"upper_ball\", inertia = [0.6, 0.9, 0.5] }\n\
                [tune.moves.ball]\npoints = [\"upper_ball\"]\nalong = \"y\"\nby = [-0.03, 0.03]\n\
                [tune.targets.mass]\nof = \"effective_mass\"\nvalue = 19.25\nwithin = 0.001\n";
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["tune", "a.toml", "--out", "b.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let tuned = std::fs::read_to_string(folder.path().join("b.toml")).expect("a motion file");
    let mass = swept(&tuned, &["--drive", "bump=0.0"])[0]["effective_mass_kg"];
    assert!((mass - 19.25).abs() < 1e-3, "{mass}");
}

/// A drawing of each case: the numbers of the table along the links, and an arrow for each load.
#[test]
fn drawings_of_load_cases_show_link_forces_and_load_arrows() {
    let cases = "contact = [-3000.0, 0.0, 4000.0]\n[loads.b]\ncontact = [0.0, 3000.0, 4000.0]\nbump = \"damper\"";
    let file = corner("", cases).replace("[masses]", "[vehicle]\nwheel_radius = 0.3\n[masses]");
    let rows = table(&file, &[]);
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), &file).expect("written");
    let output = run(folder.path(), &["loads", "a.toml", "--drawings", "out"]);
    let place = "at bump = 0.3 m, steer = 0.34 m\n";
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    for case in ["a", "b"] {
        let path = folder.path().join(format!("out/a_{case}.svg"));
        let svg = std::fs::read_to_string(path).expect("a drawing");
        for link in ["tie_rod", "pushrod", "drop_link"] {
            let force = rows[0][&format!("{case}_{link}_N")];
            assert!(
                svg.contains(&format!("\n{force:.0} N\n")),
                "{case} {link}: {force}"
            );
        }
        assert!(
            svg.contains("\n5000 N\n")
                && svg.contains(&format!("load case {case}: tension positive and blue"))
                && svg.contains(place),
            "{svg}"
        );
    }
}

/// The kinetic energy of particles, of the equivalent body, and of a rod, at the height of the wheel centre.
#[test]
fn effective_mass_gives_the_kinetic_energy_at_the_wheel_centre() {
    let around = ["--drive", "bump=-0.03:0.03:3", "--drive", "steer=0.01"];
    let rod = format!("{}\ntie_rod = 1.7", particles());
    let [of_particles, of_body, with_rod] =
        [particles(), as_body(design), rod].map(|masses| swept(&corner(&masses, ""), &around));
    for (place, row) in of_particles.iter().enumerate() {
        let along = |point: &str| {
            Vector3::from(["x", "y", "z"].map(|axis| row[&format!("{point}_{axis}_per_bump")]))
        };
        let rise = along("wheel_centre").z;
        let energies = PARTICLES.map(|(point, mass)| mass * along(point).norm_squared());
        let expected = energies.iter().sum::<f64>() / (rise * rise);
        // The rack is at rest.
        let of_rod = 1.7 / 3.0 * along("tie_ball").norm_squared() / (rise * rise);
        let found =
            [&of_particles, &of_body, &with_rod].map(|rows| rows[place]["effective_mass_kg"]);
        for (found, expected) in found
            .into_iter()
            .zip([expected, expected, expected + of_rod])
        {
            assert!(
                (found - expected).abs() < 1e-9 * expected,
                "{found} {expected}"
            );
        }
        assert!(
            (20.0..40.0).contains(&expected) && of_rod > 0.1,
            "{expected} {of_rod}"
        );
    }
    let bare = swept(&corner("", ""), &around);
    assert!(!bare[0].contains_key("effective_mass_kg"));
}
