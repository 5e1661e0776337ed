//! A user who has enough.

use std::process::{Command, Stdio};

use super::program::{command, edited, folder, rows, text};

#[test]
fn a_closed_standard_output_is_no_failure() {
    let folder = folder();
    let path = folder.path().join("long.toml");
    let long = "start = 0.0\nstop = 1.9\nstep = 0.001";
    std::fs::write(path, edited("instants", long)).expect("written");
    let mut child = command(folder.path())
        .args(["motion", "long.toml", "--csv", "-"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program runs");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("the program ends");
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(output.stderr.is_empty(), "{output:?}");
}

#[cfg(unix)]
#[test]
fn an_interrupt_keeps_whole_rows() {
    let folder = folder();
    let path = folder.path().join("long.toml");
    let long = "start = 0.0\nstop = 1.9\nstep = 5e-7";
    std::fs::write(path, edited("instants", long)).expect("written");
    let child = command(folder.path())
        .args(["motion", "long.toml", "--csv", "long.csv"])
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program runs");
    std::thread::sleep(std::time::Duration::from_millis(500));
    let interrupt = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(interrupt.expect("a signal").success());
    let output = child.wait_with_output().expect("the program ends");
    assert_eq!(output.status.code(), Some(130), "{output:?}");
    let table = std::fs::read(folder.path().join("long.csv")).expect("a table");
    assert_eq!(table.last(), Some(&b'\n'));
    assert!(!rows(&table).is_empty());
    assert!(text(&output.stderr).contains("interrupted"));
}
