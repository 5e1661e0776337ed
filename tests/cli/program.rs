//! The program and its input for tests. The parent module names the program.
#![allow(dead_code)]

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};

/// A motion file of a corner that travels and steers, at its design position.
pub(crate) const CORNER: &str = "\
linkage = \"double_wishbone_pushrod\"
unit = \"m\"
vehicle = { wheel_radius = 0.3 }
time = { instants = [0.0] }
[drives]
bump = 0.3
steer = 0.34
";

pub(crate) fn command(folder: &Path) -> Command {
    let mut command = Command::new(super::PROGRAM);
    command.current_dir(folder);
    command
}

pub(crate) fn run(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = command(folder);
    command.args(arguments).output().expect("the program runs")
}

/// Starts the program with its output in pipes.
pub(crate) fn start<A: AsRef<OsStr>>(folder: &Path, arguments: &[A]) -> Child {
    let mut command = command(folder);
    command
        .args(arguments)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program runs")
}

pub(crate) fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

pub(crate) fn example(name: &str) -> String {
    match name {
        "attia2003.toml" => include_str!("../../examples/attia2003.toml"),
        "five_link.toml" => include_str!("../../examples/five_link.toml"),
        "published_five_link.toml" => include_str!("../data/published_five_link.toml"),
        "five_link_height.toml" => include_str!("../../examples/five_link_height.toml"),
        "double_wishbone_pushrod.toml" => {
            include_str!("../../examples/double_wishbone_pushrod.toml")
        }
        "front_and_rear_axle.toml" => include_str!("../../examples/front_and_rear_axle.toml"),
        "live_axle_panhard.toml" => include_str!("../../examples/live_axle_panhard.toml"),
        other => panic!("no example {other}"),
    }
    .to_owned()
}

/// The published motion with a line, found by its beginning, replaced.
pub(crate) fn edited(begins: &str, replacement: &str) -> String {
    let text = example("attia2003.toml");
    let line = text
        .lines()
        .find(|line| line.starts_with(begins))
        .unwrap_or_else(|| panic!("no line begins with {begins}"));
    text.replacen(line, replacement, 1)
}

pub(crate) fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

pub(crate) type Rows = Vec<BTreeMap<String, f64>>;

pub(crate) fn rows(csv_text: &[u8]) -> Rows {
    let mut reader = csv::Reader::from_reader(csv_text);
    let rows = reader.deserialize().collect::<Result<_, _>>();
    rows.expect("numbers under a header")
}

/// The table of a command on files in a folder.
#[track_caller]
pub(crate) fn table_in(folder: &Path, arguments: &[&str]) -> Rows {
    let output = run(folder, &[arguments, &["--csv", "-"]].concat());
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    rows(&output.stdout)
}

/// The table of a command, the first of the arguments, on the text of a motion file.
#[track_caller]
pub(crate) fn table(file: &str, arguments: &[&str]) -> Rows {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let (command, options) = arguments.split_at(1);
    table_in(folder.path(), &[command, &["a.toml"], options].concat())
}
