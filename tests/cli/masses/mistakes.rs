//! Masses that are refused, or noted.

use super::corner;
use crate::program::{folder, run, text};

#[test]
fn an_invalid_mass_is_refused_at_its_place() {
    for (masses, case, expected) in [
        (
            "uprigth = 3.0",
            "",
            "unknown moving part `uprigth`; known are ",
        ),
        ("upright = 3.0", "", "`upright` is a body: write { mass"),
        (
            "tie_rod = -1.0",
            "",
            "the mass of `tie_rod` must be zero or a positive number of kg",
        ),
        (
            "tie_rod = { mass = 1.0, centre = \"rack\" }",
            "",
            "`tie_rod` is a link",
        ),
        (
            "lower_front = 1.0",
            "",
            "unknown moving part `lower_front`; known are ",
        ),
        (
            "upright = { mass = 1.0, centre = \"hub\" }",
            "",
            "unknown point `hub`; known are lower_front, ",
        ),
        (
            "upright = { mass = 1.0, centre = \"wheel_center\" }",
            "",
            "; did you mean `wheel_centre`?",
        ),
        (
            "upright = { mass = 1.0 }",
            "",
            "missing field `centre`; write a point or coordinates, as centre = \"wheel_centre\"",
        ),
        (
            "upright = { mass = 1.0, centre = \"wheel_centre\", inertia = 0.5 }",
            "",
            "expected a list in brackets, [...]; write the moments of inertia in kg m^2, as inertia = [0.8, 1.2, 0.8]",
        ),
        (
            "upright = { mass = 1.0, centre = \"wheel_centre\", inertia = [1.0, 1.0, 3.0] }",
            "",
            "no principal moment of inertia may be negative or larger",
        ),
        (
            "upright = { mass = 1.0, centre = \"wheel_centre\", inertia = { xx = 1.0 } }",
            "",
            "invalid type: table, expected a list in brackets, [...]",
        ),
        (
            "upright = { mass = 1.0, centre = [nan, 1.0, 2.0] }",
            "",
            "the centre of mass of `upright` is not finite",
        ),
        (
            "tie_rod = 1.0",
            "gravity = 9.81",
            "`gravity` is [x, y, z] in m/s^2",
        ),
        ("tie_rod = \"heavy\"", "", "expected a mass in kg"),
    ] {
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), corner(masses, case)).expect("written");
        let output = run(folder.path(), &["loads", "a.toml"]);
        assert_eq!(output.status.code(), Some(2), "{masses}: {output:?}");
        assert!(
            text(&output.stderr).contains(expected),
            "{expected}: {output:?}"
        );
    }
    let folder = folder();
    let file = corner("", "acceleration = [1.0, 0.0, 0.0]").replace("[masses]\n", "");
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["loads", "a.toml"]);
    assert!(
        text(&output.stderr).contains("acts on masses: state them in [masses]"),
        "{output:?}"
    );
}

/// A mass on only one of two equal parts of both sides was probably forgotten on the other.
#[test]
fn a_mass_on_one_side_alone_is_noted() {
    let notes_with = |masses: &str| {
        let folder = folder();
        let file = format!(
            "linkage = \"steered_axle\"\nunit = \"m\"\ntime = {{ instants = [0.0] }}\n\
             drives = {{ bump_left = 0.3, bump_right = 0.3, steer = 0.34 }}\n[masses]\n{masses}\n"
        );
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        text(&run(folder.path(), &["motion", "a.toml"]).stderr).to_owned()
    };
    let one = "left_wheel_centre = 20.0\nrack = 4.0\n";
    assert_eq!(
        notes_with(one),
        "note: a.toml: [masses] has `left_wheel_centre`, and `right_wheel_centre` of the other side has no mass; state it too\n"
    );
    assert_eq!(
        notes_with(&format!("{one}right_tie_rod = 0.9\n")),
        "note: a.toml: [masses] has `left_wheel_centre` and `right_tie_rod`, and `right_wheel_centre` and `left_tie_rod` of the other side have no \
         mass; state them too\n"
    );
    assert_eq!(notes_with(&format!("{one}right_wheel_centre = 20.0\n")), "");
}

/// Masses in grams, inertias in kg mm^2 and centres of mass in millimetres are refused by nobody, and wrong by orders of magnitude.
#[test]
fn masses_in_another_unit_are_noted() {
    let notes_with = |mass: &str, centre: &str, inertia: &str| {
        let folder = folder();
        let file = format!(
            "linkage = \"macpherson\"\nunit = \"m\"\ntime = {{ instants = [0.0] }}\n[drives]\nbump = 0.31\nsteer = 0.33\n\
             [masses]\nknuckle = {{ mass = {mass}, centre = {centre}, inertia = {inertia} }}\n"
        );
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        text(&run(folder.path(), &["check", "a.toml"]).stdout).to_owned()
    };
    let hub = "[0.0, 0.75, 0.3]";
    for (mass, centre, inertia, expected) in [
        ("30.0", hub, "[0.8, 1.2, 0.8]", ""),
        ("30.0", hub, "[]", ""),
        ("0.0", hub, "[0.8, 1.2, 0.8]", ""),
        (
            "30000.0",
            hub,
            "[0.8, 1.2, 0.8]",
            "the mass of `knuckle` is 30000 kg: is it in grams? Masses are in kg",
        ),
        (
            "30.0",
            hub,
            "[0.8e6, 1.2e6, 0.8e6]",
            "the inertia of `knuckle` is that of a mass 216 m from its centre: is it in kg mm^2? Inertias are in kg m^2",
        ),
        (
            "30.0",
            "[0.0, 750.0, 300.0]",
            "[0.8, 1.2, 0.8]",
            "are its coordinates in the unit and the axes of the file?",
        ),
    ] {
        let report = notes_with(mass, centre, inertia);
        assert!(report.contains(expected), "{expected}: {report}");
        assert_eq!(
            report.contains("of `knuckle` is"),
            !expected.is_empty(),
            "{report}"
        );
    }
}
