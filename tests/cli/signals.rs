//! A user who interrupts the program.

use std::ffi::OsStr;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

use super::program::{CORNER, command, edited, example, folder, start, text};

/// Runs a motion that takes seconds and ends it with a signal after a fraction of one.
fn ended_by(signal: &str, folder: &Path, results: &[&str]) -> Output {
    let long = "start = 0.0\nstop = 1.9\nstep = 5e-7";
    std::fs::write(folder.join("long.toml"), edited("instants", long)).expect("written");
    let arguments = [&["motion", "long.toml"], results].concat();
    interrupted_by(signal, folder, &arguments)
}

pub(super) fn interrupted_by(signal: &str, folder: &Path, arguments: &[&str]) -> Output {
    ended(start(folder, arguments), &[signal])
}

/// Interrupts the program half a second after it has printed a line that starts with this text; returns the output after
/// that line, and the exit status.
fn interrupted_after<A: AsRef<OsStr>>(
    line: &str,
    folder: &Path,
    arguments: &[A],
) -> (String, Output) {
    let mut child = start(folder, arguments);
    let mut printed = BufReader::new(child.stdout.take().expect("standard output"));
    let mut last = String::new();
    while last.is_empty() || !last.starts_with(line) {
        last.clear();
        assert!(printed.read_line(&mut last).expect("a line") > 0);
    }
    std::thread::sleep(Duration::from_millis(500));
    send("-INT", &child);
    let mut rest = String::new();
    printed.read_to_string(&mut rest).expect("text");
    let output = child.wait_with_output().expect("the program ends");
    assert_eq!(output.status.code(), Some(130), "{output:?}");
    (rest, output)
}

fn send(signal: &str, child: &Child) {
    let sent = Command::new("kill")
        .args([signal, &*child.id().to_string()])
        .status();
    assert!(sent.expect("a signal").success());
}

/// The end of a program that is sent signals.
fn ended(mut child: Child, signals: &[&str]) -> Output {
    for signal in signals {
        std::thread::sleep(Duration::from_millis(500));
        let has_ended = child.try_wait().expect("a state").is_some();
        assert!(!has_ended, "before {signal}");
        send(signal, &child);
    }
    let output = child.wait_with_output().expect("the program ends");
    assert_eq!(output.status.code(), Some(130), "{signals:?} {output:?}");
    assert!(text(&output.stderr).contains("interrupted"));
    output
}

#[test]
fn an_interrupted_motion_keeps_whole_rows() {
    for signal in ["-INT", "-TERM"] {
        let folder = folder();
        let output = ended_by(signal, folder.path(), &["--csv", "long.csv"]);
        let table = std::fs::read(folder.path().join("long.csv")).expect("a table");
        assert_eq!(table.last(), Some(&b'\n'));
        let mut lines = text(&table).lines().map(|line| line.split(',').count());
        let columns = lines.next().expect("headings");
        let whole = lines.filter(|numbers| *numbers == columns).count();
        let kept = format!("{whole} rows were kept");
        assert!(text(&output.stderr).contains(&kept), "{output:?}");
        let files = std::fs::read_dir(folder.path()).expect("a folder").count();
        assert_eq!(files, 2, "{signal}: nothing temporary is left");
    }
}

/// A hang-up ends it, but not under `nohup`. (Who runs the tests may ignore hang-ups.)
#[cfg(target_os = "linux")]
#[test]
fn a_hangup_ends_the_program_unless_the_signal_is_ignored() {
    let folder = folder();
    let long = "start = 0.0\nstop = 1.9\nstep = 5e-7";
    std::fs::write(folder.path().join("long.toml"), edited("instants", long)).expect("written");
    for (mode, signals) in [
        ("--default-signal=HUP", &["-HUP"][..]),
        ("--ignore-signal=HUP", &["-HUP", "-INT"]),
    ] {
        let child = Command::new("env")
            .arg(mode)
            .arg(command(folder.path()).get_program())
            .args(["motion", "long.toml", "--csv", "-"])
            .current_dir(folder.path())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program runs");
        let output = ended(child, signals);
        assert!(text(&output.stderr).contains("interrupted"), "{output:?}");
    }
}

/// Baking a surface whose tolerance no layout of patches meets takes seconds.
#[test]
fn an_interrupt_ends_the_baking_of_a_surface() {
    let folder = folder();
    std::fs::write(folder.path().join("motion.toml"), CORNER).expect("written");
    let drives = ["--drive", "bump=0.25:0.35", "--drive", "steer=0.33:0.35"];
    let arguments = [
        &["bake", "motion.toml", "--tolerance", "1e-14"][..],
        &drives,
    ]
    .concat();
    let output = interrupted_by("-INT", folder.path(), &arguments);
    assert!(text(&output.stderr).ends_with("interrupted; nothing was written\n"));
    assert!(!folder.path().join("out").exists());
}

#[test]
fn an_interrupted_comparison_says_how_far_it_came_in_the_table() {
    let folder = folder();
    let lines = (0..100_000).map(|line| format!("{},0\n", line % 50));
    let table = format!("bump [mm],toe [deg]\n{}", lines.collect::<String>());
    for (name, content) in [("a.toml", CORNER), ("m.csv", &table)] {
        std::fs::write(folder.path().join(name), content).expect("written");
    }
    let output = interrupted_by("-INT", folder.path(), &["compare", "a.toml", "m.csv"]);
    let message = text(&output.stderr);
    let expected = "m.csv: interrupted; the model was moved to ";
    assert!(message.starts_with(expected), "{message}");
    assert!(
        message.ends_with(" of 100000 measured places, nothing was written\n"),
        "{message}"
    );
}

#[test]
fn an_interrupt_ends_the_reading_of_hardpoints() {
    let folder = folder();
    let rows = (0..20_000).map(|row| format!("bolt {row}, {row}, 2, 3\n"));
    std::fs::write(folder.path().join("a.csv"), rows.collect::<String>()).expect("written");
    let output = interrupted_by("-INT", folder.path(), &["import", "a.csv"]);
    let expected = "a.csv: interrupted before it was read\n";
    assert_eq!(text(&output.stderr), expected);
}

#[test]
fn an_interrupt_without_a_table_does_not_mention_rows() {
    let folder = folder();
    let output = ended_by("-INT", folder.path(), &["--plots", "."]);
    let message = text(&output.stderr);
    assert!(message.contains("instants were solved, up to t = "));
    assert!(!message.contains("kept"), "{message}");
}

/// The input or the table may be a FIFO that no other program opens.
#[test]
fn an_interrupt_ends_waiting_for_an_unopened_fifo() {
    let folder = folder();
    let made = Command::new("mkfifo")
        .arg(folder.path().join("fifo"))
        .status();
    assert!(made.expect("a FIFO").success());
    std::fs::write(
        folder.path().join("a.toml"),
        edited("instants", "instants = [0.0]"),
    )
    .expect("written");
    for (arguments, expected) in [
        (
            &["motion", "a.toml", "--csv", "fifo"][..],
            "fifo: interrupted; nothing was written\n",
        ),
        (
            &["motion", "fifo"],
            "fifo: interrupted before it was read\n",
        ),
    ] {
        let mut child = start(folder.path(), arguments);
        std::thread::sleep(Duration::from_millis(500));
        send("-INT", &child);
        let ends = (0..200).any(|_| {
            std::thread::sleep(Duration::from_millis(50));
            child.try_wait().expect("a state").is_some()
        });
        if !ends {
            child.kill().expect("killed");
        }
        let output = child.wait_with_output().expect("the program ends");
        assert_eq!(output.status.code(), Some(130), "{arguments:?}: {output:?}");
        assert_eq!(text(&output.stderr), expected);
    }
}

/// A live axle with a Watt linkage is one part, whose search takes seconds.
fn watt_linkage() -> tempfile::TempDir {
    let folder = folder();
    let axle = include_str!("../../examples/live_axle_watt.toml");
    std::fs::write(folder.path().join("axle.toml"), axle).expect("written");
    folder
}

#[test]
fn an_interrupted_search_for_assemblies_lists_the_found_ones() {
    let folder = watt_linkage();
    let list = ["assemblies", "axle.toml", "--csv", "all.csv"];
    let output = interrupted_by("-INT", folder.path(), &list);
    let ended = "the search for those with general dimensions was ended after ";
    assert!(text(&output.stdout).contains(ended), "{output:?}");
    assert!(folder.path().join("all.csv").exists());
    let count = ["check", "axle.toml", "--assemblies"];
    let (report, output) = interrupted_after("notes         none\n", folder.path(), &count);
    assert!(report.contains(ended), "{report}");
    let message = text(&output.stderr);
    let expected =
        "axle.toml: interrupted in its search for assemblies, of which there may be more\n";
    assert!(message.ends_with(expected), "{message}");
}

/// The second interrupt comes while the found assemblies are followed to the file's lengths.
#[test]
fn a_second_interrupt_ends_the_list_of_assemblies() {
    let folder = watt_linkage();
    let mut child = command(folder.path())
        .args(["assemblies", "axle.toml"])
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program runs");
    // Long enough for the random starts, after which there are many to follow.
    std::thread::sleep(Duration::from_secs(5));
    send("-INT", &child);
    let mut stderr_lines = BufReader::new(child.stderr.take().expect("standard error"));
    let mut line = String::new();
    stderr_lines.read_line(&mut line).expect("a note");
    assert!(line.contains("interrupt again to stop this too"), "{line}");
    send("-INT", &child);
    line.clear();
    stderr_lines.read_to_string(&mut line).expect("text");
    let expected = "axle.toml: interrupted after 0 of the drive's values\n";
    assert_eq!(line, expected);
    assert_eq!(child.wait().expect("an end").code(), Some(130));
}

/// The interrupt comes after the first of many values has been listed.
#[test]
fn an_interrupted_list_keeps_the_assemblies_of_finished_values() {
    let folder = folder();
    let values = (0..400).map(|step| format!("{}", 0.7 + 1e-3 * f64::from(step)));
    std::fs::write(folder.path().join("motion.toml"), example("five_link.toml")).expect("written");
    let mut list: Vec<_> = ["assemblies", "motion.toml", "--csv", "all.csv", "--at"]
        .map(String::from)
        .into();
    list.extend(values);
    interrupted_after("", folder.path(), &list);
    let mut table = csv::Reader::from_path(folder.path().join("all.csv")).expect("a table");
    let kept: Result<Vec<_>, _> = table.records().collect();
    assert!(!kept.expect("whole rows").is_empty());
}
