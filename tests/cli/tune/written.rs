//! The file that tuning writes, and files that it must not overwrite.

use super::super::program::{folder, run, text};
use super::{DRIVES, FLAT, file, met, swept, target, tuned};

/// The tuning that moves the rack by 8 mm along its drive.
fn rack_moved(folder: &std::path::Path) -> String {
    let drives = "bump = [0.3, 0.01]\nsteer = [0.348, 0.001, 0.2]";
    let known = file(
        "double_wishbone",
        drives,
        "[points]\nrack = [0.11, 0.348, 0.2]\n",
    );
    std::fs::write(folder.join("a_tuned.toml"), known).expect("written");
    let bump_steer = swept(folder)[24]["toe_deg_per_bump"];
    format!(
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
    )
}

/// If a point of a drive is moved along the drive, the motion begins at the new position.
#[test]
fn the_tuned_motion_begins_at_the_new_design() {
    let folder = folder();
    let tune = rack_moved(folder.path());
    std::fs::write(folder.path().join("rack.csv"), "t,y\n0,0\n1,0.01\n").expect("written");
    for (before, after) in [
        ("[0.34, 0.001, 0.2]", "[0.348, 0.001, 0.2]"),
        (
            "{ mean = 0.34, amplitude = 0.01, frequency = 2 }",
            "{ mean = 0.348, amplitude = 0.01, frequency = 2 }",
        ),
        (
            "{ csv = \"rack.csv\", columns = [\"t\", \"y\"], offset = 0.34 }",
            "{ csv = \"rack.csv\", columns = [\"t\", \"y\"], offset = 0.348 }",
        ),
    ] {
        let drives = format!("bump = [0.3, 0.01]\nsteer = {before} # m");
        met(folder.path(), &file("double_wishbone", &drives, &tune));
        let written = std::fs::read_to_string(folder.path().join("a_tuned.toml")).expect("a file");
        for line in [&format!("steer = {after} # m"), "rack = [0.11, 0.348, 0.2]"] {
            assert!(written.contains(&format!("\n{line}\n")), "{written}");
        }
    }
}

/// Without an offset the values are those in a file of its own.
#[test]
fn a_recording_stays_and_is_noted() {
    let folder = folder();
    let recording = "t,rack\n0,0.34\n1,0.35\n2,0.34\n";
    std::fs::write(folder.path().join("logged.csv"), recording).expect("written");
    let steer = "{ csv = \"logged.csv\", columns = [\"t\", \"rack\"] }";
    let drives = format!("bump = [0.3, 0.01]\nsteer = {steer}");
    let tune = rack_moved(folder.path());
    let output = met(folder.path(), &file("double_wishbone", &drives, &tune));
    let note = "note: a.toml: at the design position that was found `steer` has changed by 0.008 m; its recording stays as it is; to shift it, write offset = 0.008\n";
    assert_eq!(text(&output.stderr), format!("{note}wrote a_tuned.toml\n"));
    let written = std::fs::read_to_string(folder.path().join("a_tuned.toml")).expect("a file");
    assert!(
        written.contains(&format!("\nsteer = {steer}\n")),
        "{written}"
    );
    let output = run(folder.path(), &["tune", "a.toml", "--out", "sub/b.toml"]);
    let expected = "--out sub/b.toml: the file would not be read there: ";
    assert!(text(&output.stderr).starts_with(expected), "{output:?}");
}

/// Springs have their load at the design that is found, as the file that is written says.
#[test]
fn the_tuned_file_meets_targets_of_springs() {
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
";
    let tune = tune.to_owned() + &target("wheel_rate", 10_000.0, 1.0);
    let text = file("double_wishbone_pushrod", DRIVES, &tune);
    met(folder.path(), &text);
    let found = swept(folder.path())[24]["wheel_rate_N_m"];
    assert!((found - 10_000.0).abs() < 1.001, "{found}");
}

/// A marker that the file states relative to a point moves with it.
#[test]
fn a_marker_stated_relative_to_a_tuned_point_moves_with_the_point() {
    let folder = folder();
    let marker = "[points]\nwheel_centre = [0.0, 0.75, 0.3]\naxle = { from = \"wheel_centre\", offset = [0.0, -0.1, 0.001] }\n";
    let tune = "\
[tune.moves.out]
points = [\"wheel_centre\"]
along = \"y\"
by = [-0.05, 0.05]
";
    let tune = format!("{marker}{tune}{}", target("scrub_radius", 0.03, 1e-6));
    met(folder.path(), &file("double_wishbone", DRIVES, &tune));
    let design = &swept(folder.path())[24];
    assert!((design["scrub_radius_m"] - 0.03).abs() < 1e-6, "{design:?}");
    assert!((design["wheel_centre_y"] - design["axle_y"] - 0.1).abs() < 1e-9);
}

/// Neither the listing that is read nor a file that was there is lost.
#[test]
fn tuned_points_are_added_in_the_form_of_the_file() {
    for (stated, expected) in [
        ("[points]\n# none yet\n", "[points]\ntie_ball = ["),
        (
            "[points] # of the catalogue",
            "[points] # of the catalogue\ntie_ball = [",
        ),
        ("points = {}\n", "points = { tie_ball = ["),
        (
            "points = { rack = [0.11, 0.34, 0.2] }\n",
            "points = { rack = [0.11, 0.34, 0.2], tie_ball = [",
        ),
        (
            "points.rack = [0.11, 0.34, 0.2]\n",
            "points.rack = [0.11, 0.34, 0.2]\npoints.tie_ball = [",
        ),
        ("", "within = 0.01\n\n[points]\ntie_ball = ["),
    ] {
        let heights =
            "[tune.moves.ball]\npoints = [\"tie_ball\"]\nalong = \"z\"\nby = [-0.03, 0.03]\n";
        let target =
            "[tune.targets.toe]\nof = \"toe\"\nper = \"bump\"\nvalue = 1.0\nwithin = 0.01\n";
        let tune = format!("{heights}{target}");
        let whole = file("double_wishbone", "bump = 0.3\nsteer = 0.34", &tune);
        let (head, rest) = whole.split_once("vehicle").expect("a vehicle");
        let whole = match stated.starts_with('[') {
            true => format!("{whole}{stated}"),
            false => format!("{head}{stated}vehicle{rest}"),
        };
        for lines in ["\n", "\r\n"] {
            let folder = folder();
            let output = tuned(folder.path(), &whole.replace('\n', lines));
            assert_eq!(output.status.code(), Some(0), "{stated}: {output:?}");
            let written = std::fs::read_to_string(folder.path().join("a_tuned.toml"));
            let written = written.expect("a file");
            assert!(
                written.contains(&expected.replace('\n', lines)),
                "{written}"
            );
            assert_eq!(
                written.matches('\n').count(),
                written.matches(lines).count(),
                "{written}"
            );
        }
    }
}

#[test]
fn tune_does_not_replace_existing_files_without_out() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    let drives = "bump = 0.31\nsteer = 0.33";
    let own = file("macpherson", drives, FLAT)
        .replace("linkage = \"macpherson\"", "listing = \"corner.linkage\"");
    let listing = include_str!("../../../suspension-core/src/linkages/macpherson.linkage");
    std::fs::write(path("corner.linkage"), listing).expect("written");
    std::fs::write(path("a.toml"), own).expect("written");
    std::fs::write(path("a_tuned.toml"), "mine").expect("written");
    for (arguments, expected) in [
        (
            &["tune", "a.toml"][..],
            "a_tuned.toml: exists already; --out a_tuned.toml replaces it",
        ),
        (
            &["tune", "a.toml", "--out", "corner.linkage"],
            "corner.linkage: this is the file that is read",
        ),
        (
            &["motion", "a.toml", "--csv", "corner.linkage"],
            "corner.linkage: this is the file that is read",
        ),
        (
            &["sheet", "a.toml", "--out", "corner.linkage"],
            "corner.linkage: this is the file that is read",
        ),
        (
            &["tune", "a.toml", "--out", "sub/b.toml"],
            "--out sub/b.toml: the file would not be read there",
        ),
    ] {
        let output = run(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
        assert!(
            text(&output.stderr).contains(expected),
            "{expected}: {output:?}"
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

/// Rounded hardpoints assemble at slightly different positions than the file states.
#[test]
fn rounded_hardpoints_are_written_as_assembled() {
    let folder = folder();
    let file =
        "linkage = \"macpherson\"\nunit = \"mm\"\nangle = \"deg\"\ntime = { instants = [0.0] }
[points]
lower_front = [10.0, 360.0, 190.0]
lower_rear = [-300.0, 370.0, 200.0]
rack = [-140.0, 330.0, 250.0]
top = [-30.0, 575.0, 830.0]
lower_ball = [5.0, 720.0, 170.0]
tie_ball = [-135.0, 690.0, 240.0]
wheel_centre = [0.0, 760.0, 310.0]
strut_low = [0.0, 631.0, 410.0]
strut_high = [-15.0, 603.1, 620.0]
axle = [0.0, 660.0, 310.0]
[vehicle]
wheel_radius = 300.0
[drives]
bump = 310.0
steer = 330.0
[tune.moves.height]
points = [\"tie_ball\"]
along = \"z\"
by = [-20.0, 20.0]
[tune.targets.toe]
of = \"toe\"
over = { bump = [-30.0, 30.0] }
change = 0.0
within = 0.02
";
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["tune", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let output = run(folder.path(), &["check", "a_tuned.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let tuned = std::fs::read_to_string(folder.path().join("a_tuned.toml")).expect("written");
    assert!(
        tuned.contains("lower_front = [10.0, 360.0, 190.0]\n"),
        "{tuned}"
    );
    assert!(!tuned.contains("603.1,"), "{tuned}");
}

/// The top is 1 mm off the strut's line: the file states the points of the assembled strut, in addition to the moved one.
#[test]
fn points_that_do_not_satisfy_their_listing_are_written_as_assembled() {
    let folder = folder();
    let file = "unit = \"m\"
angle = \"deg\"
vehicle = { wheel_radius = 0.3 }
time = { instants = [0.0] }
drives = { bump = 0.31, steer = 0.34 }
statements = '''
fixed: front at [0.2, 0.4, 0.2], rear at [-0.1, 0.36, 0.19], rack at [-0.12, 0.34, 0.24], top at [-0.03, 0.58, 0.85];
free: ball at [0.0, 0.72, 0.19], tie_ball at [-0.14, 0.7, 0.25], low at [0.0, 0.64, 0.4], high at [-0.015, 0.61, 0.62],
      wheel_centre at [0.0, 0.77, 0.31];
hinge arm: front, rear -> ball;
link tie_rod: rack -> tie_ball;
body knuckle: ball, tie_ball, low, high, wheel_centre;
slide strut: top on low -> high;
point axle: knuckle at [0.0, 0.68, 0.31];
drive bump: wheel_centre.z;
drive steer: rack.y;
wheel: axle -> wheel_centre;
'''
";
    let tune = "[tune.moves.tie]
points = [\"tie_ball\"]
along = \"z\"
by = [-0.02, 0.02]
[tune.targets.bump_steer]
of = \"toe\"
per = \"bump\"
value = 1.0
within = 1e-6
";
    met(folder.path(), &format!("{file}{tune}"));
    let written = std::fs::read_to_string(folder.path().join("a_tuned.toml")).expect("a file");
    assert!(written.contains("\nhigh = ["), "{written}");
    let slope = swept(folder.path())[24]["toe_deg_per_bump"];
    assert!((slope - 1.0).abs() < 1e-6, "{slope}");
    let check = run(folder.path(), &["check", "a_tuned.toml"]);
    assert!(
        text(&check.stdout).ends_with("notes         none\n"),
        "{check:?}"
    );
}

/// The point moves a third of the way to its ball joint: for a point moved by hand this gives a note.
#[test]
fn a_tuned_point_gives_no_note_on_its_unmoved_neighbours() {
    let folder = folder();
    let moved = "[points]\ntie_ball = [0.12, 0.68, 0.25]\n";
    let by_hand = file("double_wishbone", DRIVES, moved);
    std::fs::write(folder.path().join("a_tuned.toml"), by_hand).expect("written");
    let note = "[points] does not state `lower_ball`";
    let check = || run(folder.path(), &["check", "a_tuned.toml"]);
    let checked = check();
    assert!(text(&checked.stdout).contains(note), "{checked:?}");
    let bump_steer = swept(folder.path())[24]["toe_deg_per_bump"];
    let tune = format!(
        "[tune.moves.tie]\npoints = [\"tie_ball\"]\nalong = \"z\"\nby = [-0.06, 0.06]\n\
         [tune.targets.bump_steer]\nof = \"toe\"\nper = \"bump\"\nvalue = {bump_steer:?}\nwithin = 1e-5\n"
    );
    met(folder.path(), &file("double_wishbone", DRIVES, &tune));
    let checked = check();
    assert!(
        text(&checked.stdout).ends_with("notes         none\n"),
        "{checked:?}"
    );
}

/// As for other commands, `-` is standard output: the file takes the place of the report.
#[test]
fn the_tuned_file_goes_to_standard_output_for_a_hyphen() {
    let folder = folder();
    met(folder.path(), &file("double_wishbone", DRIVES, FLAT));
    let written = std::fs::read_to_string(folder.path().join("a_tuned.toml")).expect("a file");
    let output = run(folder.path(), &["tune", "a.toml", "--out", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert_eq!(text(&output.stdout), written);
    assert_eq!(text(&output.stderr), "");
    assert!(!folder.path().join("-").exists());
}
