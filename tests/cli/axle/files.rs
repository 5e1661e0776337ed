//! Statements of motion files about wheels, and their display in sheets and comparisons.

use super::super::program::{folder, run, text};
use super::{DESIGN, assert_near, file, steered, table};

#[test]
fn naming_the_travel_drive_of_each_wheel_changes_no_result() {
    let named = "travel = { left = \"bump_left\", right = \"bump_right\" }\nsteer = \"steer\"";
    let [named, unnamed] = [named, ""].map(|vehicle| {
        let file = file("steered_axle", vehicle, DESIGN);
        table(&file, &["motion"])
    });
    assert_eq!(format!("{named:?}"), format!("{unnamed:?}"));
}

#[test]
fn travel_of_an_unknown_wheel_or_drive_is_refused() {
    for (linkage, vehicle, drives, expected) in [
        (
            "steered_axle",
            "travel = { left = \"bump_left\", rihgt = \"bump_right\" }",
            DESIGN,
            "axle.toml:5:10: unknown wheel `rihgt`; known are left, right",
        ),
        (
            "steered_axle",
            "travel = { left = \"bump\" }",
            DESIGN,
            "axle.toml:5:19: unknown drive `bump`; known are steer, bump_left, bump_right",
        ),
        (
            "steered_axle",
            "steer = 3",
            DESIGN,
            "axle.toml:5:9: invalid type: integer `3`, expected \"drive\" or { wheel = \"drive\" }",
        ),
        (
            "double_wishbone",
            "travel = { left = \"bump\" }",
            "bump = 0.3\nsteer = 0.34",
            "axle.toml:5:10: unknown wheel `left`; the listing names no wheels: write the value alone, without a wheel's name",
        ),
    ] {
        let folder = folder();
        let file = file(linkage, vehicle, drives);
        std::fs::write(folder.path().join("axle.toml"), file).expect("written");
        let output = run(folder.path(), &["motion", "axle.toml"]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let message = text(&output.stderr);
        assert!(message.contains(expected), "{message}");
    }
}

/// A page and a comparison have the wheels by name, each definition once.
#[test]
fn sheets_and_comparisons_name_both_wheels_of_an_axle() {
    let folder = folder();
    let write = |name: &str, file: String| {
        std::fs::write(folder.path().join(name), file).expect("written");
    };
    write("axle.toml", steered(DESIGN));
    let corner = file("double_wishbone", "", "bump = 0.3\nsteer = 0.34");
    write("corner.toml", corner);
    let sheet = ["sheet", "axle.toml", "--out", "axle.html"];
    assert_eq!(run(folder.path(), &sheet).status.code(), Some(0));
    let page = std::fs::read_to_string(folder.path().join("axle.html")).expect("a page");
    assert_eq!(
        page.matches("<tr class=\"first\"><td rowspan=\"2\">camber angle</td><td>left</td>")
            .count(),
        1
    );
    let camber = "atan2(-s_z, |s_y|). Its derivative with respect to wheel travel is bump camber, or camber gain. Positive where the top of the wheel leans outboard (projection as in Suspension Explorer, sign of ISO 8855)";
    assert_eq!(page.matches(camber).count(), 1);
    assert!(
        !page.contains("Attia"),
        "a source that defines none of these"
    );
    for heading in ["Over heave", "Over roll", "Over steer"] {
        assert_eq!(page.matches(heading).count(), 1, "{heading}");
    }
    let output = run(folder.path(), &["compare", "axle.toml", "axle.toml"]);
    let compared = text(&output.stdout);
    for part in [
        "left and right toe angle",
        "left toe angle",
        "right toe angle",
        "per travel of the right wheel",
        "total toe",
    ] {
        assert!(compared.contains(part), "{part}");
    }
    let output = run(folder.path(), &["compare", "axle.toml", "corner.toml"]);
    let compared = text(&output.stdout);
    let mut lines = compared.lines();
    let camber = lines.find(|line| line.starts_with("  left and right camber angle"));
    let cells: Vec<&str> = camber.expect("compared").split_whitespace().collect();
    assert_eq!(cells[5..], ["0", "0", "0", "deg"]);
}

/// A place of heave and roll is that of the two drives' own values.
#[test]
fn heave_and_roll_add_up() {
    let places = |drives: [&str; 2]| {
        let [a, b] = drives;
        table(&steered(DESIGN), &["sweep", "--drive", a, "--drive", b])
    };
    let grid = places([
        "bump_left,bump_right=-0.03:0.03:3",
        "bump_left,-bump_right=-0.02:0.02:3",
    ]);
    assert_eq!(grid.len(), 9);
    for (row, (heave, roll)) in grid.iter().zip(
        [-0.03, 0.0, 0.03]
            .map(|heave| [-0.02, 0.0, 0.02].map(|roll| (heave, roll)))
            .as_flattened(),
    ) {
        let [left, right] = [heave + roll, heave - roll];
        let own = places([&format!("bump_left={left}"), &format!("bump_right={right}")]);
        for (column, value) in &own[0] {
            if !column.contains("residual") {
                assert_near(row[column], *value, 1e-9 * value.abs().max(1.0), column);
            }
        }
    }
}

/// In heave both wheels move equally; in roll one moves at some travel like the other at the opposite travel.
#[test]
fn drives_joined_in_one_sweep_option_move_together() {
    let heave = table(
        &steered(DESIGN),
        &["sweep", "--drive", "bump_left,bump_right=-0.04:0.04:3"],
    );
    for row in &heave {
        assert_near(
            row["left_camber_rad"],
            row["right_camber_rad"],
            1e-12,
            "camber",
        );
        assert_near(row["bump_left_m"], row["bump_right_m"], 1e-15, "heave");
    }
    let roll = table(
        &steered(DESIGN),
        &["sweep", "--drive", "bump_left,-bump_right=-0.04:0.04:3"],
    );
    for (row, other) in roll.iter().zip(roll.iter().rev()) {
        assert_near(row["bump_left_m"] + row["bump_right_m"], 0.6, 1e-15, "roll");
        assert_near(
            row["left_camber_rad"],
            other["right_camber_rad"],
            1e-12,
            "camber",
        );
    }
    let folder = folder();
    std::fs::write(folder.path().join("axle.toml"), steered(DESIGN)).expect("written");
    for twice in [
        &["bump_left,bump_left=0:1:2"][..],
        &["bump_left=0:1:2", "-bump_left=0:1:2"],
        &[
            "bump_left=0:1:2",
            "bump_right=0:1:2",
            "bump_left,bump_right=0:1:2",
        ],
        &["bump_left=0.3", "bump_left,bump_right=0.3", "--absolute"],
    ] {
        let options = twice
            .iter()
            .flat_map(|drives| match drives.starts_with("--") {
                true => vec![*drives],
                false => vec!["--drive", drives],
            });
        let arguments: Vec<&str> = ["sweep", "axle.toml"].into_iter().chain(options).collect();
        let output = run(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let message = text(&output.stderr);
        assert!(
            message.contains("the drive `bump_left` is given twice"),
            "{message}"
        );
    }
    let opposite = [
        "sweep",
        "axle.toml",
        "--drive",
        "-bump_left=0.3",
        "--absolute",
    ];
    let output = run(folder.path(), &opposite);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(
        text(&output.stderr).contains("-bump_left moves the opposite way"),
        "{output:?}"
    );
}
