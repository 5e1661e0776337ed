//! Missing entries, entries in the wrong place, and other files.

use super::super::program::{CORNER, edited, folder, run, text};
use super::refusal;

#[test]
fn for_a_file_in_place_of_a_command_the_command_is_named() {
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
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2));
        assert!(message.contains(&format!("tip: {advice}\n")), "{message}");
    }
}

#[test]
fn for_a_key_in_the_wrong_table_the_right_table_is_named() {
    for (line, place) in [
        ("wheel_radius = 0.3", "wheel_radius belongs under [vehicle]"),
        ("axes = 3", "axes belongs above the first table"),
        (
            "axes = \"SAE\"",
            "unit, angle and axes belong above the first table",
        ),
    ] {
        let file = CORNER.replace("steer =", &format!("{line}\nsteer ="));
        let message = refusal("motion", &[("a.toml", &file)], &[]);
        assert!(message.ends_with(place), "{message}");
    }
}

/// Among keys: above all tables and in tables without names.
#[test]
fn for_an_unknown_field_its_right_table_is_named() {
    let head = "linkage = \"trailing_arm\"\nunit = \"m\"\n";
    for (lines, key, place) in [
        ("rack_per_turn = 0.05\n", "rack_per_turn", "under [vehicle]"),
        ("time = { steer = \"bump\" }\n", "steer", "under [vehicle]"),
        (
            "time = { wheelbase = 2.6 }\n",
            "wheelbase",
            "under [vehicle]",
        ),
        ("vehicle = { step = 0.1 }\n", "step", "under [time]"),
        ("instants = [0.0]\n", "instants", "under [time]"),
        (
            "vehicle = { unit = \"m\" }\n",
            "unit",
            "above the first table",
        ),
    ] {
        let file = format!("{head}{lines}");
        let message = refusal("motion", &[("a.toml", &file)], &[]);
        let expected = format!("unknown field `{key}`; {key} belongs {place}");
        assert!(message.ends_with(&expected), "{message}");
    }
}

/// Springs, moves and targets belong in tables with their names.
#[test]
fn for_a_table_without_a_name_the_heading_to_write_is_given() {
    for (lines, heading) in [
        ("[springs]\nalong = \"bump\"\n", "[springs.NAME]"),
        ("[tune.targets]\nof = \"toe\"\n", "[tune.targets.NAME]"),
        (
            "[tune.targets]\nvalue = [0.0, 0.1]\n",
            "[tune.targets.NAME]",
        ),
        ("[tune.moves]\nalong = \"x\"\n", "[tune.moves.NAME]"),
        (
            "[tune.moves]\npoints = [\"tie_ball\"]\n",
            "[tune.moves.NAME]",
        ),
        ("[tune.moves]\nby = [-0.01, 0.01]\n", "[tune.moves.NAME]"),
    ] {
        let message = refusal("motion", &[("a.toml", &format!("{CORNER}{lines}"))], &[]);
        let expected = format!("which has a name: write its lines under {heading}");
        assert!(message.ends_with(&expected), "{message}");
    }
}

#[test]
fn all_missing_required_keys_are_reported_at_once() {
    for (file, missing) in [
        (
            "linkage = \"trailing_arm\"\nunit = \"m\"\n",
            ["time", "drives"].as_slice(),
        ),
        ("linkage = \"trailing_arm\"\n", &["unit", "time", "drives"]),
        ("unit = \"m\"\ntime = { instants = [0.0] }\n", &["drives"]),
    ] {
        let message = refusal("motion", &[("a.toml", file)], &[]);
        assert_eq!(message.lines().count(), 1, "{message}");
        let missing_fields = message.matches("missing field `").count();
        assert_eq!(missing_fields, missing.len(), "{message}");
        for name in missing {
            assert!(
                message.contains(&format!("missing field `{name}`; write ")),
                "{message}"
            );
        }
    }
}

#[test]
fn a_missing_key_is_reported_with_the_line_to_write() {
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
        let message = refusal("sheet", &[("a.toml", &CORNER.replace(line, ""))], &[]);
        assert!(message.contains(expected), "{message}");
    }
}

#[test]
fn all_missing_lengths_are_named() {
    let file = edited("d7_2", "").replace("\nd7_6", "\n# d7_6");
    let message = refusal("motion", &[("a.toml", &file)], &[]);
    assert!(
        message.ends_with("lengths `d7_2`, `d7_6` are missing"),
        "{message}"
    );
}

#[test]
fn points_without_position_are_named_with_the_line_to_write() {
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
        let message = refusal("motion", &files, &[]);
        assert!(message.ends_with(expected), "{message}");
    }
}

#[test]
fn a_file_of_another_kind_is_identified_in_the_message() {
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
            "this is not a motion file; suspension import makes one from hardpoints",
        ),
        (
            "a.toml",
            "\n",
            "the file is empty; suspension motion --help shows what a motion file contains",
        ),
    ] {
        let message = refusal("sheet", &[(name, content)], &[]);
        assert!(message.contains(expected), "{message}");
    }
}

#[test]
fn a_mistake_in_a_listing_file_is_reported_at_its_place() {
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
            "a.linkage:8:8: point `lower_rear` is in the same place as point `lower_front`; correct one of them, or, if they are one \
             joint, state one point and name it in the statements of both",
        ),
        (
            "lower_rear  at [-0.20,",
            "lower_rear  at [rear,",
            "a.linkage:8:24: a coordinate or a factor must be a finite decimal number that begins with a digit or `-`, for example `0.5` or `-1.25`",
        ),
    ] {
        let listing = listing.replace(from, to);
        let files = [("a.toml", motion.as_str()), ("a.linkage", &listing)];
        assert_eq!(refusal("motion", &files, &[]), expected);
    }
    // If the motion file moves one of the two, there is no mistake.
    let folder = folder();
    let listing = listing.replace("lower_rear  at [-0.20,", "lower_rear  at [0.20,");
    let moved = format!("{motion}[points]\nlower_rear = [-0.2, 0.35, 0.16]\n");
    std::fs::write(folder.path().join("a.linkage"), listing).expect("written");
    std::fs::write(folder.path().join("a.toml"), moved).expect("written");
    let output = run(folder.path(), &["motion", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}

#[test]
fn an_unreadable_listing_is_reported_at_the_line_that_names_it() {
    let motion = CORNER.replace(
        "linkage = \"double_wishbone_pushrod\"",
        "listing = \"y.linkage\"",
    );
    let message = refusal("motion", &[("x.toml", &motion)], &[]);
    assert!(
        message.starts_with("x.toml:1:11: y.linkage: cannot be read: "),
        "{message}"
    );
}
