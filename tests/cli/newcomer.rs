//! Mistakes of a first motion file, each told with what to write instead.

use super::program::{CORNER, edited, folder, run, text};

/// What is said of files that a command is given, the first of them.
fn refusal(command: &str, files: &[(&str, &str)], options: &[&str]) -> String {
    let folder = folder();
    for (name, content) in files {
        std::fs::write(folder.path().join(name), content).expect("written");
    }
    let output = run(folder.path(), &[&[command, files[0].0], options].concat());
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    text(&output.stderr).trim_end().to_owned()
}

#[test]
fn a_mistyped_name_is_told_the_one_that_was_meant() {
    for (from, to, expected) in [
        ("[drives]", "[drive]", "; did you mean `drives`?"),
        (
            "double_wishbone_pushrod",
            "double_wishbone_pusrod",
            "; did you mean `double_wishbone_pushrod`?",
        ),
        ("steer =", "ster =", "; did you mean `steer`?"),
        (
            "wheel_radius",
            "tyre_radius",
            "; did you mean `wheel_radius`?",
        ),
        (
            "wheel_radius = 0.3",
            "travel = \"bumb\"",
            "; did you mean `bump`?",
        ),
    ] {
        let said = refusal("motion", &[("a.toml", &CORNER.replace(from, to))], &[]);
        assert!(
            said.starts_with("a.toml:") && said.ends_with(expected),
            "{said}"
        );
    }
}

#[test]
fn a_mistyped_drive_of_an_option_is_told_the_one_that_was_meant() {
    for (command, options) in [
        ("sweep", ["--drive", "bumb=0:0.01:2"].as_slice()),
        ("assemblies", &["--drive", "bumb", "--at", "0.3"]),
        ("bake", &["--drive", "bumb=0.29:0.31"]),
    ] {
        let said = refusal(command, &[("a.toml", CORNER)], options);
        let expected = "unknown drive `bumb`; known are bump, steer; did you mean `bump`?";
        assert!(said.ends_with(expected), "{said}");
    }
}

#[test]
fn a_mistyped_option_is_told_the_one_that_was_meant() {
    for (command, wrong, meant) in [
        ("motion", "--cvs", "--csv"),
        ("motion", "--jsno", "--json"),
        ("sweep", "--drives", "--drive"),
        ("sheet", "--otu", "--out"),
    ] {
        let said = refusal(command, &[("a.toml", CORNER)], &[wrong, "x"]);
        let expected = format!("tip: a similar argument exists: '{meant}'");
        assert!(said.contains(&expected), "{said}");
        assert!(!said.contains("to pass"), "{said}");
    }
}

#[test]
fn a_file_in_place_of_a_command_is_told_the_command() {
    for (file, advice) in [
        (
            "a.toml",
            "for the motion of a file write suspension motion a.toml",
        ),
        (
            "a.csv",
            "for a motion file of hardpoints write suspension import a.csv",
        ),
        (
            "a.linkage",
            "a motion file names a listing: listing = \"a.linkage\"",
        ),
    ] {
        let output = run(folder().path(), &[file]);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2));
        assert!(said.contains(&format!("tip: {advice}\n")), "{said}");
    }
}

#[test]
fn a_key_in_the_wrong_table_is_told_where_it_stands() {
    for (line, place) in [
        ("wheel_radius = 0.3", "wheel_radius stands under [vehicle]"),
        ("axes = 3", "axes stands above the first table"),
        (
            "axes = \"SAE\"",
            "unit, angle and axes stand above the first table",
        ),
    ] {
        let file = CORNER.replace("steer =", &format!("{line}\nsteer ="));
        let said = refusal("motion", &[("a.toml", &file)], &[]);
        assert!(said.ends_with(place), "{said}");
    }
}

#[test]
fn a_key_that_is_missing_is_told_with_what_to_write() {
    for (line, expected) in [
        (
            "unit = \"m\"\n",
            "missing field `unit`; write unit = \"m\", \"mm\" or \"in\"",
        ),
        (
            "time = { instants = [0.0] }\n",
            "missing field `time`; write [time] with start, stop and step",
        ),
        (
            "[drives]\nbump = 0.3\nsteer = 0.34\n",
            "missing field `drives`; write [drives] with a line for each",
        ),
    ] {
        let said = refusal("sheet", &[("a.toml", &CORNER.replace(line, ""))], &[]);
        assert!(said.contains(expected), "{said}");
    }
}

#[test]
fn all_lengths_that_are_missing_are_named() {
    let file = edited("d7_2", "").replace("\nd7_6", "\n# d7_6");
    let said = refusal("motion", &[("a.toml", &file)], &[]);
    assert!(
        said.ends_with("lengths `d7_2`, `d7_6` are missing"),
        "{said}"
    );
}

#[test]
fn a_point_without_position_is_told_where_to_write_it() {
    let motion = "listing = \"a.linkage\"\nunit = \"m\"\ntime = { instants = [0.0] }\ndrives = { lift = 0.0 }\n";
    let listing = "fixed: fore at [0.3, 0.0, 0.0], aft;\nfree: tip;\nlink front: fore -> tip;\n\
                   link rear: aft -> tip;\ndrive lift: tip.z;\n";
    for (tip, expected) in [
        (
            "",
            "points `aft`, `tip` have no position; write `aft at [x, y, z]` in the listing, or aft = [x, y, z] under [points]",
        ),
        (
            "points = { tip = [0.0, 0.4, 0.0] }\n",
            "point `aft` has no position; write `aft at [x, y, z]` in the listing, or aft = [x, y, z] under [points]",
        ),
    ] {
        let motion = format!("{motion}{tip}");
        let files = [("a.toml", motion.as_str()), ("a.linkage", listing)];
        let said = refusal("motion", &files, &[]);
        assert!(said.ends_with(expected), "{said}");
    }
}

#[test]
fn a_file_of_another_kind_is_named_as_what_it_is() {
    let listing = "//! An arm.\nfixed: hinge at [0.0, 0.0, 0.0];\n";
    for (name, content, expected) in [
        (
            "a.linkage",
            listing,
            "this is a listing; a motion file names it: listing = \"FILE\"",
        ),
        (
            "a.csv",
            "lca_front, 1, 2, 3\n",
            "this is no motion file; suspension import makes one of hardpoints",
        ),
    ] {
        let said = refusal("sheet", &[(name, content)], &[]);
        assert!(said.contains(expected), "{said}");
    }
}

#[test]
fn a_mistake_of_a_listing_is_told_at_its_place_there() {
    let (_, listing) = suspension_core::linkages::LISTINGS
        .iter()
        .find(|(name, _)| *name == "double_wishbone_pushrod")
        .expect("in the catalogue");
    let motion = CORNER.replace(
        "linkage = \"double_wishbone_pushrod\"",
        "listing = \"a.linkage\"",
    );
    for (from, to, expected) in [
        (
            "lower_rear  at [-0.20,",
            "lower_rear  at [0.20,",
            "a.linkage:8:8: point `lower_rear` is in the same place as point `lower_front`",
        ),
        (
            "lower_rear  at [-0.20,",
            "lower_rear  at [rear,",
            "a.linkage:8:24: a coordinate or a factor is a finite number, for example `-1.25`",
        ),
    ] {
        let listing = listing.replace(from, to);
        let files = [("a.toml", motion.as_str()), ("a.linkage", &listing)];
        assert_eq!(refusal("motion", &files, &[]), expected);
    }
    // Where the motion file moves one of the two, nothing is wrong.
    let folder = folder();
    let listing = listing.replace("lower_rear  at [-0.20,", "lower_rear  at [0.20,");
    let moved = format!("{motion}[points]\nlower_rear = [-0.2, 0.35, 0.16]\n");
    std::fs::write(folder.path().join("a.linkage"), listing).expect("written");
    std::fs::write(folder.path().join("a.toml"), moved).expect("written");
    let output = run(folder.path(), &["motion", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}

#[test]
fn a_listing_that_cannot_be_read_is_told_with_the_line_that_names_it() {
    let motion = CORNER.replace(
        "linkage = \"double_wishbone_pushrod\"",
        "listing = \"y.linkage\"",
    );
    let said = refusal("motion", &[("x.toml", &motion)], &[]);
    assert!(
        said.starts_with("x.toml:1:11: y.linkage: cannot be read: "),
        "{said}"
    );
}

/// A corner whose statements are those of the catalogue, with some points in the motion file.
fn corner_with(points: &str) -> String {
    format!("{CORNER}[points]\n{points}\n")
}

#[test]
fn a_point_in_another_unit_is_named_first_at_its_place() {
    // The spin axis has no length: the marker is where the wheel centre is.
    let flat = "axle = { from = \"wheel_centre\", offset = [0.0, 0.0, 0.0] }\n";
    let said = refusal(
        "motion",
        &[(
            "a.toml",
            &corner_with(&format!("{flat}lower_ball = [0.005, 700.0, 0.17]")),
        )],
        &[],
    );
    let first = "a.toml:10:14: `lower_ball` lies 699 m from the other points: is it in mm?\n";
    assert!(said.starts_with(first), "{said}");
    assert_eq!(said.lines().count(), 2, "{said}");
}

#[test]
fn a_point_in_another_unit_with_which_a_mechanism_can_be_built_is_remarked() {
    let folder = folder();
    for (points, expected) in [
        ("lower_ball = [0.005, 0.71, 0.17]", ""),
        (
            "damper_inner = [0.02, 120.0, 0.54]",
            "note: a.toml: `damper_inner` lies 119 m from the other points: is it in mm?\n",
        ),
        (
            "damper_inner = [0.02, 12.0, 0.54]",
            "note: a.toml: `damper_inner` lies 11.3 m from the other points: is it in inches?\n",
        ),
        (
            "damper_inner = [0.02, 0.32, 2.4]",
            "note: a.toml: `damper_inner` lies 1.8 m from the other points: should its z be 0.24 instead of 2.4?\n",
        ),
        (
            "damper_inner = [0.02, 850.0, 0.54]",
            "note: a.toml: `damper_inner` lies 849 m from the other points: is it in mm?\n",
        ),
        (
            "damper_inner = [0.02, 3.2, 0.54]",
            "note: a.toml: `damper_inner` lies 2.46 m from the other points: should its y be 0.32 instead of 3.2?\n",
        ),
    ] {
        std::fs::write(folder.path().join("a.toml"), corner_with(points)).expect("written");
        let output = run(folder.path(), &["motion", "a.toml"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        assert_eq!(text(&output.stderr), expected);
    }
}

#[test]
fn a_measure_is_not_listed_among_the_drives() {
    let said = refusal("sweep", &[("a.toml", CORNER)], &["--drive", "damper=0:1:3"]);
    assert_eq!(
        said,
        "`damper` is a measure, no drive; the drives are bump, steer"
    );
    let said = refusal(
        "motion",
        &[("a.toml", &CORNER.replace("steer =", "heave ="))],
        &[],
    );
    let expected = "unknown drive `heave`; the drives are bump, steer, and in place of one may lead damper, bar_arm";
    assert!(said.contains(expected), "{said}");
}

#[test]
fn a_stop_between_two_steps_is_not_reached_without_a_word() {
    let folder = folder();
    let said = |step: &str| {
        let file = CORNER.replace(
            "instants = [0.0]",
            &format!("start = 0, stop = 1, step = {step}"),
        );
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let output = run(folder.path(), &["motion", "a.toml"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        text(&output.stderr).to_owned()
    };
    assert_eq!(said("0.1"), "");
    assert_eq!(
        said("0.3"),
        "note: a.toml: the motion ends at t = 0.9 s: its stop at 1 s is no whole number of steps of 0.3 s\n"
    );
}

#[test]
fn a_mistyped_key_is_told_with_the_one_that_is_near() {
    for (mistyped, expected) in [
        (
            "linkag =",
            "a.toml:1:1: unknown field `linkag`; did you mean `linkage`?",
        ),
        (
            "speed =",
            "a.toml:1:1: unknown field `speed`, expected one of `linkage`, ",
        ),
    ] {
        let file = CORNER.replace("linkage =", mistyped);
        let said = refusal("motion", &[("a.toml", &file)], &[]);
        assert!(said.starts_with(expected), "{said}");
    }
}

/// In binary the motion is shorter than its one step: 0.3 - 0.1 < 0.2.
#[test]
fn a_step_as_long_as_the_motion_leads_to_its_end() {
    let folder = folder();
    let time = "time = { start = 0.1, stop = 0.3, step = 0.2 }";
    let file = CORNER.replace("time = { instants = [0.0] }", time);
    assert!(file.contains(time), "{file}");
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["motion", "a.toml", "--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert_eq!(text(&output.stdout).lines().count(), 3);
}
