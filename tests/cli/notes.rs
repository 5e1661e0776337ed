//! The program's notes on a file that runs.

mod bars;
mod doubtful;
mod driven;
mod sides;
mod steering;
mod travel;

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
fn hardpoints_in_another_unit_are_noted() {
    let millimetres = example("five_link.toml");
    assert_eq!(notes(&millimetres), "");
    let metres = millimetres.replace("unit = \"mm\"", "unit = \"m\"");
    let message = notes(&metres);
    assert!(
        message.starts_with("note: a.toml: the points are up to 537 m apart"),
        "{message}"
    );
    assert!(message.contains("unit = \"mm\""), "{message}");
    let inches = millimetres.replace("unit = \"mm\"", "unit = \"in\"");
    let message = notes(&inches);
    assert!(
        message.contains("537 in apart: is the file in mm?"),
        "{message}"
    );
}

#[test]
fn a_point_that_lengths_move_elsewhere_is_noted() {
    assert_eq!(notes(&example("attia2003.toml")), "");
    let message = notes(&edited("p8", "p8 = [-1.27, 0.345, 0.218]"));
    assert!(
        message.starts_with("note: a.toml: with [lengths]") && message.contains("`p8` 0.101 m"),
        "{message}"
    );
}

#[test]
fn a_reversed_kingpin_or_spin_axis_is_noted() {
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
fn vehicle_lengths_in_another_unit_are_noted() {
    let file = |vehicle: &str| {
        example("five_link.toml").replace("[time]", &format!("[vehicle]\n{vehicle}\n[time]"))
    };
    let car = |wheelbase: &str, height: &str| {
        format!(
            "axle = \"rear\"\nwheel_radius = 320.0\nwheelbase = {wheelbase}\ncg_height = {height}\nbrake_share = 0.4\ntravel = \"theta\""
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
            "note: a.toml: wheel_radius is 6000 mm: it is usually from 50 mm to 5000 mm; is the number right?\n",
        ),
    ] {
        assert_eq!(notes(&file(&vehicle)), expected);
    }
}

/// A strut of the catalogue with its top mount moved outboard, and more tables.
fn strut(outboard: f64, more: &str) -> String {
    format!(
        "linkage = \"macpherson\"\nunit = \"m\"\npoints = {{ top = [-0.03, {}, 0.83] }}\n{more}\
         time = {{ instants = [0.0] }}\ndrives = {{ bump = 0.31, steer = 0.33 }}\n",
        0.575 + outboard
    )
}

#[test]
fn small_misfits_of_points_are_noted_with_and_without_a_design() {
    let design = "design = { bump = 0.33, steer = 0.33 }\n";
    assert_eq!(notes(&strut(0.0, "")), notes(&strut(0.0, design)));
    for more in ["", design] {
        let message = notes(&strut(0.01, more));
        assert!(
            message.starts_with(
                "note: a.toml: the points do not satisfy equation `strut_y` of slide `strut`, by "
            ),
            "{message}"
        );
    }
    assert!(notes(&strut(0.01, "")).contains("has moved by"));
    assert!(notes(&strut(0.01, design)).ends_with("of the assembled mechanism\n"));
}

#[test]
fn points_far_from_their_equations_are_refused() {
    for more in ["", "design = { bump = 0.31, steer = 0.33 }\n"] {
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), strut(-0.15, more)).expect("written");
        let output = run(folder.path(), &["motion", "a.toml"]);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(
            message.starts_with(
                "a.toml:1:11: the points do not satisfy equation `strut_y` of slide `strut`, by "
            ),
            "{message}"
        );
        assert!(
            message.contains("more than a tenth of the suspension's size; correct a point of the statement that has this equation"),
            "{message}"
        );
        assert!(text(&output.stdout).is_empty());
    }
}

/// The wheel centre of the published motion by coordinates, all of the guess moved rearward.
fn guessed(back: f64) -> String {
    let points = [
        ("p6", [-1.324, 0.415, -0.059]),
        ("p7", [-1.327, 0.41, 0.155]),
        ("p8", [-1.287, 0.345, 0.14]),
        ("p9", [-1.29, 0.325, -0.084]),
        ("p10", [-1.212, 0.453, 0.089]),
        ("p11", [-1.287, 0.445, 0.14]),
    ];
    let mut text = example("attia2003.toml");
    for (name, [x, y, z]) in points {
        let begin = format!("{name} = ");
        let line = text.lines().find(|line| line.starts_with(&begin));
        let line = line.expect("the point").to_owned();
        text = text.replacen(&line, &format!("{name} = [{}, {y}, {z}]", x - back), 1);
    }
    text
}

#[test]
fn a_marker_with_coordinates_moves_with_its_body() {
    let moved = |back| {
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), guessed(back)).expect("written");
        let output = run(folder.path(), &["motion", "a.toml", "--csv", "-"]);
        super::program::rows(&output.stdout)
    };
    let (expected, found) = (moved(0.0), moved(0.01));
    assert!(!expected.is_empty());
    for (expected, found) in expected.iter().zip(&found) {
        for name in ["p11_x", "p11_y", "p11_z"] {
            assert!((expected[name] - found[name]).abs() < 1e-9, "{name}");
        }
    }
}

/// A seat on a link of each side, at the same distance from the link.
const SEATS: &str = "unit = \"mm\"
statements = '''
mirror: left -> right;
fixed: left_front at [200, 350, 160], left_rear at [-200, 350, 160], rack_left at [110, 340, 200];
fixed: left_in at [-50, 330, 400];
free: left at [0, 700, 200], left_hub at [0, 690, 300], left_out at [-50, 660, 410];
free: left_seat at [-50, 495, 415];
hinge left_arm: left_front, left_rear -> left;
body left_post: left, left_hub, left_out;
link left_upper: left_in -> left_out;
link left_tie: rack_left -> left_hub;
link left_back: left_front -> left_hub;
slide left_seat_on_upper: left_seat on left_in -> left_out;
link left_seat_from_in: left_in -> left_seat;
drive left_bump: left.z;
'''
time = { instants = [0.0] }
drives = { left_bump = 200, right_bump = 200 }
";

#[test]
fn notes_on_two_equal_sides_name_the_same_side() {
    let message = notes(SEATS);
    assert!(
        message.contains(
            "equation `left_seat_on_upper_z` of slide `left_seat_on_upper`, by 9.99 mm; "
        ),
        "{message}"
    );
    assert!(
        message.contains("`left_seat` has moved by 10 mm"),
        "{message}"
    );
}
