//! `suspension sensitivities` of an axle: the intended wheel, and the points that move together.

use super::super::program::{folder, run, text};
use super::table;

#[test]
fn for_quantities_of_an_axle_names_with_its_wheels_are_proposed() {
    let folder = folder();
    let axle = include_str!("../../../examples/steered_axle.toml");
    std::fs::write(folder.path().join("axle.toml"), axle).expect("written");
    for (of, expected) in [
        (
            "bump_steer",
            "`bump_steer` is the derivative of `left_toe` or `right_toe` with respect to a drive of travel; name `left_toe` or `right_toe` in its place\n",
        ),
        (
            "steering_ratio",
            "there is no `steering_ratio` of this mechanism: it needs rack_per_turn under [vehicle], see suspension motion --help\n",
        ),
    ] {
        let output = run(folder.path(), &["sensitivities", "axle.toml", "--of", of]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert_eq!(text(&output.stderr), format!("axle.toml: {expected}"));
    }
    for (of, meant) in [
        ("toe", "`left_toe`, `right_toe` or `total_toe`"),
        (
            "kingpin_offset",
            "`left_kingpin_offset` or `right_kingpin_offset`",
        ),
    ] {
        let output = run(folder.path(), &["sensitivities", "axle.toml", "--of", of]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let expected = format!(
            "axle.toml: no quantity begins with `{of}`; did you mean {meant}? Without --of all quantities are printed\n"
        );
        assert_eq!(text(&output.stderr), expected);
    }
}

/// The rack of a mirrored axle slides in a housing: if its end is moved across the line, the housing and the other end
/// follow, so that the height of the rack affects bump steer like that of a rack on a chassis point. Along the line it moves
/// alone.
#[test]
fn moving_a_rack_end_moves_the_line_and_the_other_end() {
    let file = |layout: &str, drives: &str| {
        format!(
            "linkage = \"{layout}\"\nunit = \"m\"\nvehicle = {{ wheel_radius = 0.3 }}\ntime = {{ instants = [0.0] }}\n\
             drives = {{ {drives}, steer = 0.34 }}\n"
        )
    };
    let axle = table(&file("steered_axle", "bump_left = 0.3, bump_right = 0.3"));
    let corner = table(&file("double_wishbone", "bump = 0.3"));
    for axis in ["x", "z"] {
        let rack = &corner[&format!("rack.{axis}")];
        let (one, other) = (
            &axle[&format!("rack_left.{axis}")],
            &axle[&format!("rack_right.{axis}")],
        );
        for (found, expected) in [
            ("left_toe_rad_per_bump_left", "toe_rad_per_bump"),
            ("right_toe_rad_per_bump_right", "toe_rad_per_bump"),
            ("left_toe_rad", "toe_rad"),
            ("left_camber_rad_per_steer", "camber_rad_per_steer"),
        ] {
            let expected = rack[expected];
            for row in [one, other] {
                let found = row[found];
                assert!(
                    (found - expected).abs() < 1e-9 * (1.0 + expected.abs()),
                    "{axis}: {found} {expected}"
                );
            }
        }
    }
    assert!(corner["rack.z"]["toe_rad_per_bump"].abs() > 10.0);
    let along = &axle["rack_left.y"];
    assert!(
        along["left_toe_rad"].abs() < 1e-9,
        "the tie rod is made for the rack's place"
    );
    assert!(along["right_toe_rad"].abs() < 1e-9);
}

/// Each wheel of an axle is moved by its own drive: most derivatives with respect to the other one are zero.
#[test]
fn zero_and_unchanged_quantities_are_gathered_in_one_line() {
    let folder = folder();
    let axle = include_str!("../../../examples/steered_axle.toml");
    std::fs::write(folder.path().join("axle.toml"), axle).expect("written");
    let report = |of: &str| {
        let output = run(folder.path(), &["sensitivities", "axle.toml", "--of", of]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        text(&output.stdout).to_owned()
    };
    let toe = report("left_toe");
    let gathered = "\n0, and nothing changes it: left_toe per bump_right\n";
    assert!(toe.ends_with(gathered), "{toe}");
    assert!(!toe.contains("left_toe per bump_right: 0"), "{toe}");
    assert!(toe.contains("\nleft_toe per bump_left: "), "{toe}");
    // Another value that nothing changes is shown.
    let height = report("left_centre_z");
    let shown = "\nleft_centre_z per bump_left: 1 m/m\n  nothing changes it\n";
    assert!(height.contains(shown), "{height}");
    let gathered =
        "\n0, and nothing changes them: left_centre_z per steer, left_centre_z per bump_right\n";
    assert!(height.ends_with(gathered), "{height}");
}

/// A quantity of each wheel also needs the missing line; a wheel's name in the wrong place is not a quantity.
#[test]
fn a_missing_quantity_of_one_wheel_names_the_line_to_write() {
    let folder = folder();
    let axle = include_str!("../../../examples/steered_axle.toml");
    std::fs::write(folder.path().join("axle.toml"), axle).expect("written");
    let refusal = |of: &str| {
        let output = run(folder.path(), &["sensitivities", "axle.toml", "--of", of]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        text(&output.stderr).to_owned()
    };
    let needs =
        "of this mechanism: it needs rack_per_turn under [vehicle], see suspension motion --help\n";
    for name in ["left_steering_ratio", "right_steering_wheel_angle"] {
        assert_eq!(
            refusal(name),
            format!("axle.toml: there is no `{name}` {needs}")
        );
    }
    // Without the wheels' radius there is no ground.
    let floating = axle.replace("wheel_radius", "# wheel_radius");
    assert_ne!(floating, axle);
    std::fs::write(folder.path().join("axle.toml"), floating).expect("written");
    for name in ["axle_roll_centre", "left_roll_centre"] {
        let needs = "it needs wheel_radius under [vehicle], see suspension motion --help\n";
        let expected = format!("axle.toml: there is no `{name}` of this mechanism: {needs}");
        assert_eq!(refusal(name), expected);
    }
    let unknown = refusal("middle_steering_ratio");
    assert!(
        unknown.starts_with("axle.toml: no quantity begins with"),
        "{unknown}"
    );
    let target = format!(
        "{axle}[tune.moves.ball]\npoints = [\"left_tie_ball\"]\nalong = \"z\"\nby = [-0.01, 0.01]\n\
         [tune.targets.wanted]\nof = \"left_steering_ratio\"\nvalue = 15.0\nwithin = 0.1\n"
    );
    std::fs::write(folder.path().join("tuned.toml"), target).expect("written");
    let output = run(folder.path(), &["tune", "tuned.toml"]);
    let messages = text(&output.stderr);
    assert!(
        messages.ends_with(&format!("there is no `left_steering_ratio` {needs}")),
        "{messages}"
    );
}
