//! Notes on values that a file states or leaves to its listing, and that are probably mistakes.

use super::super::program::{CORNER, example, folder, run, text};
use super::notes;

/// Points that the file does not state keep their positions in the listing: a note says so if the points around them are
/// elsewhere.
#[test]
fn a_point_left_behind_by_moved_neighbours_is_noted() {
    let file =
        |points: &str| CORNER.replace("vehicle =", &format!("points = {{ {points} }}\nvehicle ="));
    let at_centre = |height: &str| {
        file(&format!("wheel_centre = [0.0, 0.75, {height}]"))
            .replace("bump = 0.3", &format!("bump = {height}"))
    };
    let relative = "axle = { from = \"wheel_centre\", offset = [0, -0.1, 0] }";
    for (file, expected) in [
        // The spin axis has another direction.
        (
            at_centre("0.31"),
            Some((
                "[points] does not state `axle`, which",
                "`wheel_centre` is 0.01 m from",
                relative,
            )),
        ),
        // With the line that the note proposes the file is correct.
        (
            at_centre("0.31").replace("points = {", &format!("points = {{ {relative},")),
            None,
        ),
        // A change of a hardpoint that may be intended.
        (file("tie_ball = [0.12, 0.68, 0.20]"), None),
        (file("lower_front = [0.20, 0.35, 0.16]"), None),
        // Another body.
        (
            file("upper_ball = [-0.015, 0.60, 0.48], tie_ball = [0.12, 0.60, 0.24]"),
            Some((
                "does not state `lower_ball`, `wheel_centre`, `axle`, which keep",
                "`tie_ball` is 0.0854 m from",
                "state them too",
            )),
        ),
    ] {
        let message = notes(&file);
        let Some((which, beside, remedy)) = expected else {
            assert_eq!(message, "");
            continue;
        };
        for expected in [which, beside, remedy] {
            assert!(message.contains(expected), "{message}");
        }
    }
}

/// One point on the other side than its wheel: of a corner, or of an axle a point with the wheel's name.
#[test]
fn a_point_on_the_wrong_side_is_noted() {
    let corner = |point: &str| {
        let corner = CORNER.replace("double_wishbone_pushrod", "double_wishbone");
        let corner = corner.replace("steer = 0.34\n", "");
        corner.replace("vehicle =", &format!("points = {{ {point} }}\nvehicle =")) + "steer = "
    };
    let axle = |point: &str| {
        format!(
            "linkage = \"steered_axle\"\nunit = \"m\"\ntime = {{ instants = [0.0] }}\npoints = {{ {point} }}\n\
             drives = {{ bump_left = 0.3, bump_right = 0.3, steer = 0.34 }}\n"
        )
    };
    for (file, point, centre) in [
        (
            corner("lower_rear = [-0.20, -0.35, 0.16]") + "0.34\n",
            "lower_rear",
            "wheel_centre",
        ),
        (
            corner("rack = [0.11, -0.34, 0.20]") + "-0.34\n",
            "rack",
            "wheel_centre",
        ),
        (
            corner("upper_ball = [-0.015, -0.66, 0.44]") + "0.34\n",
            "upper_ball",
            "wheel_centre",
        ),
        (
            axle("right_upper_rear = [-0.15, 0.43, 0.42]"),
            "right_upper_rear",
            "right_wheel_centre",
        ),
    ] {
        let expected = format!("`{point}` is on the other side of the vehicle than `{centre}`");
        let message = notes(&file);
        assert!(message.contains(&expected), "{message}");
    }
    assert_eq!(notes(&axle("right_upper_rear = [-0.15, -0.42, 0.42]")), "");
}

/// The note accompanies its consequence: a motion that its drives cannot begin.
#[test]
fn a_point_on_the_wrong_side_is_noted_with_a_motion_out_of_reach() {
    let file = CORNER.replace("double_wishbone_pushrod", "double_wishbone");
    let file = file.replace(
        "vehicle =",
        "points = { upper_ball = [-0.015, -0.66, 0.44] }\nvehicle =",
    );
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file.replace("0.3\n", "0.6\n")).expect("written");
    let output = run(folder.path(), &["motion", "a.toml"]);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let message = text(&output.stderr);
    assert!(
        message.contains("is out of reach from the design position"),
        "{message}"
    );
    let doubt = "\na.toml: `upper_ball` is on the other side of the vehicle than `wheel_centre`";
    assert_eq!(message.matches(doubt).count(), 1, "{message}");
}

/// Exchanged points of the wheel or of its axis are noted; usual toe and camber are not.
#[test]
fn a_spin_axis_far_from_the_y_direction_is_noted() {
    let file = |points: &str| {
        let file = CORNER.replace("double_wishbone_pushrod", "double_wishbone");
        file.replace("vehicle =", &format!("points = {{ {points} }}\nvehicle ="))
    };
    let message = notes(&file("axle = [0.1, 0.69, 0.3]"));
    let expected = "note: a.toml: the spin axis of the wheel, from `axle` to `wheel_centre`, is 59 deg off the y direction at the design";
    assert!(message.contains(expected), "{message}");
    let message = notes(&file("axle = [0.02, 0.65, 0.32]"));
    assert!(!message.contains("off the y direction"), "{message}");
}

/// The lower ball joint and the front bush of its wishbone in each other's places give a kingpin that lies.
#[test]
fn a_kingpin_far_from_the_vertical_is_noted() {
    let file = |points: &str| {
        let file = CORNER.replace("double_wishbone_pushrod", "double_wishbone");
        file.replace("vehicle =", &format!("points = {{ {points} }}\nvehicle ="))
    };
    let doubt = "deg off the vertical";
    let message = notes(&file(
        "lower_ball = [0.20, 0.35, 0.16], lower_front = [0.005, 0.70, 0.17]",
    ));
    // From [0.20, 0.35, 0.16] to [-0.015, 0.66, 0.44].
    let off = 0.215_f64.hypot(0.31).atan2(0.28).to_degrees();
    let expected = format!(
        "note: a.toml: the kingpin of the wheel, from `lower_ball` to `upper_ball`, is {off:.1} {doubt} at the design position: are"
    );
    assert!(message.contains(&expected), "{message}");
    let message = notes(&file("upper_ball = [-0.195, 0.60, 0.44]"));
    assert!(!message.contains(doubt), "{message}");
}

/// Values of drives in another unit, or counted from elsewhere, than the file's or the option's.
#[test]
fn drive_values_in_another_unit_or_from_another_zero_are_noted() {
    let folder = folder();
    let notes_with = |bump: &str, arguments: &[&str]| {
        let file = CORNER.replace("bump = 0.3", &format!("bump = {bump}"));
        let file = file.replace("instants = [0.0]", "start = 0.0, stop = 1.0, step = 0.5");
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        text(&run(folder.path(), arguments).stderr).to_owned()
    };
    let motion = ["motion", "a.toml"];
    let sweep = |bump| ["sweep", "a.toml", "--csv", "/dev/null", "--drive", bump];
    for (bump, arguments, expected) in [
        (
            "[300, 50]",
            motion.as_slice(),
            "a.toml: [drives]: is `bump` in mm? The file is in m",
        ),
        (
            "[0.3, 50]",
            &motion,
            "a.toml: [drives]: is `bump` in mm? The file is in m",
        ),
        (
            "[0.0, 0.05]",
            &motion,
            "a.toml: [drives]: `bump` takes the drive's own value, not a change from the design position: `bump` is 0.3 m at \
             the design position; write bump = [0.3, ...]",
        ),
        (
            "0.3",
            &sweep("bump=-80:80:3"),
            "note: a.toml: --drive: is `bump` in mm? The file is in m",
        ),
        (
            "0.3",
            &sweep("bump=0.25:0.35:3"),
            "note: a.toml: --drive: `bump` takes a change from the design position, not the drive's own value: `bump` is 0.3 m \
             at the design position; use --absolute to state its own values",
        ),
        (
            "0.3",
            &[&sweep("bump=-0.05:0.05:3")[..], &["--absolute"]].concat(),
            "`bump` takes the drive's own value, not a change from the design position: `bump` is 0.3 m at the design position; \
             leave out --absolute to state changes",
        ),
    ] {
        let message = notes_with(bump, arguments);
        assert!(message.contains(expected), "{bump}: {message}");
    }
    for arguments in [
        &motion[..],
        &sweep("bump=-0.05:0.05:3"),
        &[&sweep("bump=0.25:0.35:3")[..], &["--absolute"]].concat(),
    ] {
        let message = notes_with("[0.3, 0.05]", arguments);
        assert!(!message.contains("note:"), "{message}");
    }
}

#[test]
fn a_rate_of_a_spring_in_another_unit_is_noted() {
    let in_degrees =
        example("double_wishbone_pushrod.toml").replace("unit =", "angle = \"deg\"\nunit =");
    let noted = |along: &str, rate: &str| {
        let spring = format!("\n[springs.main]\nalong = \"{along}\"\nrate = {rate}\n");
        notes(&format!("{in_degrees}{spring}"))
    };
    for (along, rate) in [
        ("damper", "28000.0"),
        ("damper", "0.0"),
        ("bar_arm", "300.0"),
    ] {
        assert_eq!(noted(along, rate), "", "{along} {rate}");
    }
    let why = "rates are per unit of lengths or angles of the file\n";
    for (along, rate, doubt) in [
        (
            "damper",
            "28.0",
            "28 N per m; it is usually from 500 to 5e6 N per m",
        ),
        (
            "bar_arm",
            "30000.0",
            "30000 N m per deg; it is usually from 0.08727 to 3491 N m per deg",
        ),
    ] {
        let message = noted(along, rate);
        let expected = format!("the rate of spring `main` is {doubt}: {why}");
        assert!(message.ends_with(&expected), "{message}");
    }
}

/// In the mirror image of a corner, y of the rack has the other sign.
#[test]
fn a_drive_with_the_sign_of_the_other_side_is_reported_as_such() {
    let folder = folder();
    std::fs::write(
        folder.path().join("a.toml"),
        CORNER.replace("0.34", "-0.34"),
    )
    .expect("written");
    let output = run(folder.path(), &["motion", "a.toml"]);
    let expected = "a.toml: [drives]: is the sign of `steer` right? `steer` is 0.34 m at the design position; write steer = [0.34, ...]\n";
    assert!(text(&output.stderr).contains(expected), "{output:?}");
}
