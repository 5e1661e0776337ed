//! The ranges that are baked, and the messages about those that are not.

use std::path::Path;

use super::super::program::{example, folder, run, text};

#[test]
fn bake_without_options_bakes_the_motion_of_the_file_into_out() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    let output = run(folder.path(), &["bake", "a.toml"]);
    assert_eq!(output.status.code(), Some(0));
    let message = text(&output.stderr);
    let path = Path::new("out").join("a_wheel_by_theta.rs");
    let wrote = format!(
        "wrote {}: theta from 0.7 to 2.1503125 rad, ",
        path.display()
    );
    assert!(message.starts_with(&wrote), "{message}");
    let file = std::fs::read_to_string(folder.path().join("out/a_wheel_by_theta.rs"));
    let file = file.expect("a file");
    assert!(file.contains("// Drive: theta from 0.7 to 2.1503125 rad."));
    assert!(file.contains("// Tolerance asked: 1e-6 m; reached: "));
}

#[test]
fn one_baked_segment_is_printed_in_the_singular() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    let arguments = ["bake", "a.toml", "--from", "1", "--to", "1.0001"];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let message = text(&output.stderr).trim_end();
    assert!(
        message.ends_with(": theta from 1 to 1.0001 rad, 1 segment"),
        "{message}"
    );
    let file = std::fs::read_to_string(folder.path().join("out/a_wheel_by_theta.rs"));
    let file = file.expect("a file");
    assert!(file.contains("// 1 segment of degree 5, "), "{file}");
}

#[test]
fn spaces_around_the_name_of_a_baked_drive_mean_nothing() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    for drive in [
        &[" theta = 1:1.0001"][..],
        &[" theta ", "--from", "1", "--to", "1.0001"],
    ] {
        let output = run(
            folder.path(),
            &[&["bake", "a.toml", "--drive"], drive].concat(),
        );
        assert_eq!(output.status.code(), Some(0), "{output:?}");
    }
}

#[test]
fn a_refused_range_is_reported_with_a_possible_one() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    for (ends, reason, kept) in [
        (["0.5", "2.5"], "the drive `theta` locks at", ""),
        (
            ["0.5", "1.37"],
            "the drive `theta` locks at",
            " --to 1.37\n",
        ),
        (
            ["0.663", "2"],
            "256 segments do not meet 1e-6 m about theta = 0.66",
            " --to 2\n",
        ),
        (["2.2", "3"], "the drive `theta` locks at", ""),
    ] {
        let [from, to] = ends;
        let output = run(
            folder.path(),
            &["bake", "a.toml", "--from", from, "--to", to],
        );
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(3), "{message}");
        assert_eq!(message.lines().count(), 1, "{message}");
        let begin = format!("a.toml: theta cannot be baked from {from} to {to}: {reason}");
        assert!(message.starts_with(&begin), "{message}");
        let (_, advice) = message.split_once("possible is ").expect("advice");
        assert!(advice.ends_with(kept), "{advice}");
        let possible: Vec<&str> = advice.split_whitespace().collect();
        let output = run(
            folder.path(),
            &[&["bake", "a.toml"], &possible[..]].concat(),
        );
        assert_eq!(output.status.code(), Some(0), "{advice}");
    }
}

#[test]
fn wrong_arguments_of_bake_give_exit_code_2_and_one_sentence() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    for (arguments, expected) in [
        (
            &["--drive", "bump"][..],
            "a.toml: unknown drive `bump`; known are theta",
        ),
        (
            &["--from", "2", "--to", "1"],
            "a.toml: theta = 2 rad to theta = 1 rad is not a range",
        ),
        (
            &["--from", "nan"],
            "a.toml: theta = NaN rad to theta = 2.15031 rad is not a range",
        ),
        (
            &["--from", "-0.1"],
            "a.toml: theta = -0.1 rad to theta = 2.15031 rad: the angle of a",
        ),
        (
            &["--tolerance", "0"],
            "a.toml: --tolerance 0 is not a positive number of metres, as 1e-6",
        ),
        (
            &["--tolerance", "-1"],
            "a.toml: --tolerance -1 is not a positive number of metres, as 1e-6",
        ),
        (
            &["--out", "./a.toml"],
            "./a.toml: this is the file that is read, which --out would",
        ),
    ] {
        let output = run(folder.path(), &[&["bake", "a.toml"], arguments].concat());
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert_eq!(message.lines().count(), 1, "{message}");
        assert!(message.starts_with(expected), "{message}");
    }
    let output = run(folder.path(), &["bake", "a.toml", "--tolerance", "1e-30"]);
    assert_eq!(output.status.code(), Some(3));
    let message = text(&output.stderr);
    assert!(
        message.ends_with("no part of the range can be baked\n"),
        "{message}"
    );
}

/// Other commands count from the design position. Where no part of the range is within reach that is the whole message, without a part
/// that is possible.
#[test]
fn a_range_that_counts_from_the_design_is_corrected_in_the_message() {
    let folder = folder();
    std::fs::write(
        folder.path().join("a.toml"),
        example("double_wishbone_pushrod.toml"),
    )
    .expect("written");
    let bake = |range: &str| {
        let output = run(folder.path(), &["bake", "a.toml", "--drive", range]);
        text(&output.stderr).to_owned()
    };
    let own = "`bump` takes the drive's own value, not a change from the design position: `bump` is 0.3 m at the design position; for \
               that range about the design write --drive bump=";
    let message = bake("bump=-0.03:0.03");
    let expected = format!("a.toml: bump cannot be baked from -0.03 to 0.03: {own}0.27:0.33\n");
    assert_eq!(message, expected);
    let message = bake("bump=0.01:0.2");
    assert!(
        message.starts_with(&format!("note: a.toml: {own}0.31:0.5\n")),
        "{message}"
    );
    assert!(message.contains("possible is --from 0.1"), "{message}");
    let message = bake("bump=0.27:0.33");
    assert!(!message.contains("note:"), "{message}");
}

#[test]
fn an_option_of_bake_without_a_number_is_refused_with_its_format() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    for (option, wanted) in [
        (
            "--from",
            "X is a number, the drive's own value in the file's units, as 0.30",
        ),
        (
            "--to",
            "Y is a number, the drive's own value in the file's units, as 0.30",
        ),
        ("--tolerance", "M is a number of metres, as 1e-6"),
        ("--continuity", "write 0, 1 or 2"),
    ] {
        let output = run(folder.path(), &["bake", "a.toml", option, "x"]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let message = text(&output.stderr);
        assert!(
            message.contains(option) && message.contains(wanted),
            "{message}"
        );
    }
}

#[test]
fn unknown_orders_of_derivatives_are_refused_with_the_known_ones() {
    let folder = folder();
    let wanted = "write 0, 1 or 2";
    for value in ["3", "-1", "1.0", "two"] {
        for command in [
            ["bake", "a.toml", "--continuity", value].as_slice(),
            &[
                "sweep",
                "a.toml",
                "--drive",
                "bump=0",
                "--derivatives",
                value,
            ],
        ] {
            let output = run(folder.path(), command);
            assert_eq!(output.status.code(), Some(2), "{output:?}");
            let message = text(&output.stderr);
            assert!(message.contains(wanted), "{message}");
        }
    }
}
