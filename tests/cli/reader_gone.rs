//! Standard output or standard error that cannot be written: the reader has ended, or the device is full.

use std::path::Path;
#[cfg(unix)]
use std::process::Stdio;

#[cfg(unix)]
use super::program::command;
use super::program::{CORNER, edited, example, folder, start, text};

#[test]
fn a_closed_standard_output_gives_exit_code_0() {
    let folder = folder();
    let path = folder.path().join("long.toml");
    let long = "start = 0.0\nstop = 1.9\nstep = 0.001";
    std::fs::write(path, edited("instants", long)).expect("written");
    assert_silent_success_without_a_reader(folder.path(), &["motion", "long.toml", "--csv", "-"]);
}

/// Runs the program with a standard output whose reader goes at once; returns what it says.
#[track_caller]
fn succeeds_without_a_reader(folder: &Path, arguments: &[&str]) -> Vec<u8> {
    let mut child = start(folder, arguments);
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("the program ends");
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    output.stderr
}

#[track_caller]
fn assert_silent_success_without_a_reader(folder: &Path, arguments: &[&str]) {
    let stderr = succeeds_without_a_reader(folder, arguments);
    assert!(stderr.is_empty(), "{}", text(&stderr));
}

/// For example `suspension tune corner.toml | head`.
#[test]
fn files_are_written_after_the_reader_of_stdout_has_gone() {
    let folder = folder();
    let tune = "[tune]\nmoves.up = { points = [\"rack\"], along = \"z\", by = [-0.01, 0.01] }\n\
                targets.upright = { of = \"camber\", value = 0.0, within = 1.0 }\n";
    let long = edited("instants", "start = 0.0\nstop = 1.9\nstep = 0.001");
    for (name, content) in [
        ("corner.toml", format!("{CORNER}{tune}")),
        ("links.toml", example("five_link.toml")),
        ("long.toml", long),
    ] {
        std::fs::write(folder.path().join(name), content).expect("written");
    }
    for (arguments, file) in [
        ("tune corner.toml --out found.toml", "found.toml"),
        (
            "compare corner.toml corner.toml --html both.html",
            "both.html",
        ),
        (
            "compare corner.toml corner.toml --csv - --json both.json",
            "both.json",
        ),
        (
            "compare corner.toml corner.toml --json - --html of_json.html",
            "of_json.html",
        ),
        ("sensitivities corner.toml --csv all.csv", "all.csv"),
        ("assemblies links.toml --csv found.csv", "found.csv"),
        ("motion long.toml --csv - --json rows.json", "rows.json"),
        (
            "motion corner.toml --csv - --plots plots",
            "plots/corner_height.svg",
        ),
        #[cfg(feature = "parquet")]
        (
            "motion corner.toml --parquet - --plots of_parquet",
            "of_parquet/corner_height.svg",
        ),
    ] {
        let arguments: Vec<&str> = arguments.split(' ').collect();
        succeeds_without_a_reader(folder.path(), &arguments);
        assert!(folder.path().join(file).exists(), "{arguments:?}");
    }
}

/// If notes and errors cannot be written, only these are lost.
#[cfg(unix)]
#[test]
fn results_are_written_with_a_full_standard_error() {
    let folder = folder();
    std::fs::write(folder.path().join("motion.toml"), CORNER).expect("written");
    let code = |arguments: &[&str]| {
        let full = std::fs::File::create("/dev/full").expect("a full device");
        let mut command = command(folder.path());
        let status = command
            .args(arguments)
            .stdout(Stdio::null())
            .stderr(full)
            .status();
        status.expect("the program runs").code()
    };
    assert_eq!(
        code(&["motion", "motion.toml", "--csv", "all.csv"]),
        Some(0)
    );
    assert!(folder.path().join("all.csv").exists());
    assert_eq!(code(&["motion", "nothing.toml"]), Some(2));
    assert_eq!(code(&["motion", "--nothing"]), Some(2));
}

#[cfg(unix)]
#[test]
fn unwritable_help_gives_exit_code_1() {
    let full = std::fs::File::create("/dev/full").expect("a full device");
    let mut command = command(Path::new("."));
    let output = command.args(["motion", "--help"]).stdout(full).output();
    let output = output.expect("the program runs");
    assert_eq!(output.status.code(), Some(1));
    let message = "standard output: cannot be written: No space left on device";
    assert!(text(&output.stderr).starts_with(message), "{output:?}");
}

/// The same applies to results.
#[test]
fn help_to_a_closed_standard_output_gives_exit_code_0() {
    // The text may have been written before the reader went.
    assert_silent_success_without_a_reader(Path::new("."), &["motion", "--help"]);
}
