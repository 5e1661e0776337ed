//! Hardpoints moved until curves are met.

mod units;

use std::path::Path;
use std::process::Output;

use super::program::{Rows, folder, rows, run, text};

/// A motion file of a layout of the catalogue, with what it says of tuning.
fn file(layout: &str, drives: &str, tune: &str) -> String {
    let head = format!("linkage = \"{layout}\" # as drawn\nunit = \"m\"\nangle = \"deg\"\n");
    let rest = format!(
        "vehicle = {{ wheel_radius = 0.3 }}\ntime = {{ instants = [0.0] }}\n[drives]\n{drives}\n"
    );
    format!("{head}{rest}{tune}")
}

/// Both ends of the tie rod up and down, for the least toe change over 60 mm of bump and rebound.
const FLAT: &str = "\
[tune.moves.rack_height]
points = [\"rack\"]
along = \"z\"
by = [-0.03, 0.03]
[tune.moves.ball_height]
points = [\"tie_ball\"]
along = [0, 0, 2]
by = [-0.03, 0.03]
[tune.targets.bump_steer]
of = \"toe\"
over = { bump = [-0.06, 0.06] }
change = 0.0
within = 0.02
";

fn tuned(folder: &Path, file: &str) -> Output {
    std::fs::write(folder.join("a.toml"), file).expect("written");
    // Of the design that a test has read before.
    let _ = std::fs::remove_file(folder.join("a_tuned.toml"));
    run(folder, &["tune", "a.toml"])
}

/// What the program reads of the file that it wrote, over bump.
fn swept(folder: &Path) -> Rows {
    let sweep = [
        "sweep",
        "a_tuned.toml",
        "--drive",
        "bump=-0.06:0.06:49",
        "--csv",
        "-",
    ];
    let output = run(folder, &sweep);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    rows(&output.stdout)
}

#[test]
fn bump_steer_of_three_layouts_is_flat_by_two_heights() {
    for (layout, drives) in [
        ("double_wishbone", "bump = 0.3\nsteer = 0.34"),
        ("macpherson", "bump = 0.31\nsteer = 0.33"),
        ("five_link_rack", "bump = 0.32\nsteer = 0.35"),
    ] {
        let folder = folder();
        let output = tuned(folder.path(), &file(layout, drives, FLAT));
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let rows = swept(folder.path());
        let design = rows[24]["toe_deg"];
        let worst = rows.iter().map(|row| (row["toe_deg"] - design).abs());
        let worst = worst.fold(0.0, f64::max);
        assert!(worst <= 0.02, "{layout}: {worst}");
        let written = std::fs::read_to_string(folder.path().join("a_tuned.toml")).expect("a file");
        assert!(
            written.starts_with(&file(layout, drives, FLAT)),
            "{written}"
        );
        let added: Vec<&str> = written.lines().rev().take(2).collect();
        assert!(added[0].starts_with("tie_ball = [") && added[1].starts_with("rack = ["));
    }
}

/// A box that is too small stops a move, and the message says which.
#[test]
fn what_is_not_met_is_told_with_the_box_that_stops_it() {
    let folder = folder();
    let small = FLAT.replacen("by = [-0.03, 0.03]", "by = [-0.001, 0.03]", 1);
    let output = tuned(
        folder.path(),
        &file("macpherson", "bump = 0.31\nsteer = 0.33", &small),
    );
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let told = "a.toml: not met: bump_steer; at the end of their boxes: rack_height";
    assert!(text(&output.stderr).contains(told), "{output:?}");
    assert!(
        text(&output.stdout).contains("rack_height  -0.001"),
        "{output:?}"
    );
    let rows = swept(folder.path());
    let off = rows
        .iter()
        .map(|row| (row["toe_deg"] - rows[24]["toe_deg"]).abs());
    assert!(off.fold(0.0, f64::max) > 0.02);
}

/// The tables of a design with points elsewhere are reached by moving these there: a list has a number for each place, a
/// derivative is a target like a value.
#[test]
fn a_known_design_is_found_by_its_curves() {
    let folder = folder();
    let drives = "bump = 0.3\nsteer = 0.34";
    let known = "[points]\nupper_front = [0.15, 0.42, 0.432]\nupper_rear = [-0.15, 0.42, 0.432]\n";
    let known = file("double_wishbone", drives, known);
    std::fs::write(folder.path().join("a_tuned.toml"), known).expect("written");
    let rows = swept(folder.path());
    let design = &rows[24];
    let camber =
        [0, 12, 24, 36, 48].map(|row: usize| rows[row]["camber_deg"] - design["camber_deg"]);
    let slope = design["camber_deg_per_bump"];
    let tune = format!(
        "\
[tune.moves.upper_arm]
points = [\"upper_rear\", \"upper_front\"]
along = \"z\"
by = [-0.03, 0.03]
[tune.targets.camber]
of = \"camber\"
over = {{ bump = [-0.06, 0.06] }}
change = {camber:?}
within = 1e-3
[tune.targets.slope]
of = \"camber\"
per = \"bump\"
value = {slope:?}
within = 0.1
"
    );
    let points =
        "[points]\nupper_front = [0.15, 0.42, 0.42]\nupper_rear = [-0.15, 0.42, 0.42] # both\n";
    let output = tuned(
        folder.path(),
        &file("double_wishbone", drives, &format!("{points}{tune}")),
    );
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(
        text(&output.stdout).contains("upper_arm  0.012 m"),
        "{output:?}"
    );
    let written = std::fs::read_to_string(folder.path().join("a_tuned.toml")).expect("a file");
    assert!(
        written.contains("upper_rear = [-0.15, 0.42, 0.432] # both\n"),
        "{written}"
    );
    let found = &swept(folder.path())[48];
    assert!(
        (found["camber_deg"] - rows[48]["camber_deg"]).abs() < 1e-6,
        "{found:?}"
    );
}

/// Left as right: the file that is written is symmetric.
#[test]
fn mirrored_points_keep_an_axle_symmetric() {
    let folder = folder();
    let tune = "\
[tune.moves.rack]
points = [\"left_axle\"]
mirrored = [\"right_axle\"]
along = [1.0, 1.0, 0.0]
by = [-0.02, 0.02]
[tune.targets.toe]
of = \"left_toe\"
value = 0.1
within = 1e-5
";
    let drives = "bump_left = 0.3\nbump_right = 0.3\nsteer = 0.0";
    let output = tuned(folder.path(), &file("steered_axle", drives, tune));
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let output = run(
        folder.path(),
        &[
            "sweep",
            "a_tuned.toml",
            "--drive",
            "steer=0.0",
            "--csv",
            "-",
        ],
    );
    let row = &rows(&output.stdout)[0];
    assert!((row["left_toe_deg"] - 0.1).abs() < 1e-5, "{row:?}");
    assert!(
        (row["left_toe_deg"] - row["right_toe_deg"]).abs() < 1e-6,
        "{row:?}"
    );
}

/// A turnbuckle: the tie rod's length sets the toe, and the rack stays.
#[test]
fn a_length_is_a_move_too() {
    let folder = folder();
    let tune = "\
[tune.moves.turnbuckle]
length = \"tie_rod\"
by = [-0.005, 0.005]
[tune.targets.toe]
of = \"toe\"
value = -0.25
within = 1e-5
";
    let drives = "bump = 0.3\nsteer = 0.34";
    let output = tuned(folder.path(), &file("double_wishbone", drives, tune));
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let row = &swept(folder.path())[24];
    assert!((row["toe_deg"] + 0.25).abs() < 1e-5, "{row:?}");
    let written = std::fs::read_to_string(folder.path().join("a_tuned.toml")).expect("a file");
    assert!(written.contains(&format!("{drives}\n")) && !written.contains("\nrack ="));
}

/// Where a point of a drive is moved along it, the motion begins there.
#[test]
fn drives_begin_where_the_design_has_them() {
    let folder = folder();
    let drives = "bump = [0.3, 0.01]\nsteer = [0.348, 0.001, 0.2]";
    let known = file(
        "double_wishbone",
        drives,
        "[points]\nrack = [0.11, 0.348, 0.2]\n",
    );
    std::fs::write(folder.path().join("a_tuned.toml"), known).expect("written");
    let bump_steer = swept(folder.path())[24]["toe_deg_per_bump"];
    let tune = format!(
        "\
[tune.moves.rack]
points = [\"rack\"]
along = \"y\"
by = [-0.01, 0.01]
[tune.targets.bump_steer]
of = \"toe\"
per = \"bump\"
value = {bump_steer:?}
within = 1e-5
"
    );
    let drives = "bump = [0.3, 0.01]\nsteer = [0.34, 0.001, 0.2] # m";
    let output = tuned(folder.path(), &file("double_wishbone", drives, &tune));
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let written = std::fs::read_to_string(folder.path().join("a_tuned.toml")).expect("a file");
    assert!(
        written.contains("\nsteer = [0.348, 0.001, 0.2] # m\n"),
        "{written}"
    );
    assert!(
        written.contains("\nrack = [0.11, 0.348, 0.2]\n"),
        "{written}"
    );
}

/// Springs have their load at the design that is found, as the file that is written says.
#[test]
fn what_springs_do_is_met_by_the_file_that_is_written() {
    let folder = folder();
    let tune = "\
[springs.spring]
along = \"damper\"
rate = 28000.0
load = 3800.0
[tune.moves.lower]
points = [\"damper_inner\"]
along = \"z\"
by = [-0.05, 0.05]
[tune.targets.rate]
of = \"wheel_rate\"
value = 10000.0
within = 1.0
";
    let drives = "bump = 0.3\nsteer = 0.34";
    let output = tuned(
        folder.path(),
        &file("double_wishbone_pushrod", drives, tune),
    );
    let found = swept(folder.path())[24]["wheel_rate_N_m"];
    let is_met = output.status.code() == Some(0);
    assert_eq!(
        is_met,
        (found - 10000.0).abs() < 1.001,
        "{found} {output:?}"
    );
    assert!(is_met, "{output:?}");
}

/// A marker that the file states off a point goes with it.
#[test]
fn a_marker_follows_the_point_that_it_is_stated_off() {
    let folder = folder();
    let marker = "[points]\nwheel_centre = [0.0, 0.75, 0.3]\naxle = { from = \"wheel_centre\", offset = [0.0, -0.1, 0.001] }\n";
    let tune = "\
[tune.moves.out]
points = [\"wheel_centre\"]
along = \"y\"
by = [-0.05, 0.05]
[tune.targets.scrub]
of = \"scrub_radius\"
value = 0.03
within = 1e-6
";
    let drives = "bump = 0.3\nsteer = 0.34";
    let text = file("double_wishbone", drives, &format!("{marker}{tune}"));
    let output = tuned(folder.path(), &text);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let design = &swept(folder.path())[24];
    assert!((design["scrub_radius_m"] - 0.03).abs() < 1e-6, "{design:?}");
    assert!((design["wheel_centre_y"] - design["axle_y"] - 0.1).abs() < 1e-9);
}

/// Neither the listing that is read nor a file that was there is lost.
#[test]
fn what_is_there_is_not_replaced_unasked() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    let drives = "bump = 0.31\nsteer = 0.33";
    let own = file("macpherson", drives, FLAT)
        .replace("linkage = \"macpherson\"", "listing = \"corner.linkage\"");
    let listing = include_str!("../../suspension-core/src/linkages/macpherson.linkage");
    std::fs::write(path("corner.linkage"), listing).expect("written");
    std::fs::write(path("a.toml"), own).expect("written");
    std::fs::write(path("a_tuned.toml"), "mine").expect("written");
    for (arguments, told) in [
        (
            &["tune", "a.toml"][..],
            "a_tuned.toml: exists already; --out a_tuned.toml replaces it",
        ),
        (
            &["tune", "a.toml", "--out", "corner.linkage"],
            "corner.linkage: this is a file that is read",
        ),
        (
            &["motion", "a.toml", "--csv", "corner.linkage"],
            "corner.linkage: this is a file that is read",
        ),
        (
            &["sheet", "a.toml", "--out", "corner.linkage"],
            "corner.linkage: this is a file that is read",
        ),
        (
            &["tune", "a.toml", "--out", "sub/b.toml"],
            "--out sub/b.toml: the file would not be read there",
        ),
    ] {
        let output = run(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
        assert!(
            super::program::text(&output.stderr).contains(told),
            "{told}: {output:?}"
        );
    }
    assert_eq!(
        std::fs::read_to_string(path("corner.linkage")).expect("there"),
        listing
    );
    assert_eq!(
        std::fs::read_to_string(path("a_tuned.toml")).expect("there"),
        "mine"
    );
}
