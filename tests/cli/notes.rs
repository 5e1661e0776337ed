//! What the program remarks on a file that runs.

use super::program::{edited, example, folder, run, text};

/// The notes on a file.
fn notes(content: &str) -> String {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), content).expect("written");
    let output = run(folder.path(), &["motion", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    text(&output.stderr).to_owned()
}

#[test]
fn hardpoints_in_another_unit_are_remarked() {
    let millimetres = example("five_link.toml");
    assert_eq!(notes(&millimetres), "");
    let metres = millimetres.replace("unit = \"mm\"", "unit = \"m\"");
    let told = notes(&metres);
    assert!(
        told.starts_with("note: a.toml: the points are up to 537 m apart"),
        "{told}"
    );
    assert!(told.contains("unit = \"mm\""), "{told}");
    let inches = millimetres.replace("unit = \"mm\"", "unit = \"in\"");
    let told = notes(&inches);
    assert!(told.contains("537 in apart: is the file in mm?"), "{told}");
}

#[test]
fn a_moved_point_that_lengths_put_elsewhere_is_remarked() {
    assert_eq!(notes(&example("attia2003.toml")), "");
    let told = notes(&edited("p8", "p8 = [-1.27, 0.345, 0.218]"));
    assert!(
        told.starts_with("note: a.toml: with [lengths]") && told.contains("`p8` 0.101 m"),
        "{told}"
    );
}

#[test]
fn axes_that_are_stated_the_other_way_round_are_remarked() {
    let folder = super::program::folder();
    let listings = suspension_core::linkages::LISTINGS;
    let (_, listing) = listings
        .iter()
        .find(|(name, _)| *name == "double_wishbone")
        .expect("in the catalogue");
    let motion = |radius: &str| {
        format!(
            "listing = \"a.linkage\"\nunit = \"m\"\nvehicle = {{ wheel_radius = {radius} }}\n\
             time = {{ instants = [0.0] }}\ndrives = {{ bump = 0.3, steer = 0.34 }}\n"
        )
    };
    for (from, to, radius, expected) in [
        ("", "", "0.3", ""),
        (
            "lower_ball -> upper_ball;",
            "upper_ball -> lower_ball;",
            "0.3",
            "the kingpin points downwards; write `kingpin: lower_ball -> upper_ball;`",
        ),
        (
            "axle -> wheel_centre;",
            "wheel_centre -> axle;",
            "0.3",
            "the spin axis points inboard; write `wheel: axle -> wheel_centre;`",
        ),
        (
            "",
            "",
            "320.0",
            "wheel_radius is 320 m: is it in mm? The file is in m",
        ),
    ] {
        let turned = listing.replace(from, to);
        let turned = if from.is_empty() {
            (*listing).to_owned()
        } else {
            turned
        };
        std::fs::write(folder.path().join("a.linkage"), turned).expect("written");
        std::fs::write(folder.path().join("a.toml"), motion(radius)).expect("written");
        let output = super::program::run(folder.path(), &["motion", "a.toml"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let notes = super::program::text(&output.stderr);
        assert_eq!(notes.is_empty(), expected.is_empty(), "{notes}");
        assert!(notes.contains(expected), "{notes}");
    }
}

#[test]
fn lengths_of_the_vehicle_in_another_unit_are_remarked() {
    let file = |vehicle: &str| {
        example("five_link.toml").replace("[time]", &format!("[vehicle]\n{vehicle}\n[time]"))
    };
    let car = |wheelbase: &str, height: &str| {
        format!(
            "axle = \"rear\"\nwheel_radius = 320.0\nwheelbase = {wheelbase}\ncg_height = {height}\nbrake_share = 0.4"
        )
    };
    assert_eq!(notes(&file(&car("2600.0", "500.0"))), "");
    for (vehicle, expected) in [
        (
            car("2.6", "500.0"),
            "note: a.toml: wheelbase is 2.6 mm: is it in m? The file is in mm\n",
        ),
        (
            car("2600.0", "0.5"),
            "note: a.toml: cg_height is 0.5 mm: is it in m? The file is in mm\n",
        ),
        (
            "wheel_radius = 12.6".to_owned(),
            "note: a.toml: wheel_radius is 12.6 mm: is it in inches? The file is in mm\n",
        ),
        (
            "wheel_radius = 6000.0".to_owned(),
            "note: a.toml: wheel_radius is 6000 mm: it is in the unit of the file\n",
        ),
    ] {
        assert_eq!(notes(&file(&vehicle)), expected);
    }
}
