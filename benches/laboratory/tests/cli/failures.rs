//! The failure map.

use std::path::Path;

use suspension_laboratory::failures::rows::{Axis, LongRow, Row};

use super::program::{edited, example, folder, run, text};

fn table<R: serde::de::DeserializeOwned>(path: &Path) -> Vec<R> {
    let mut reader = csv::Reader::from_path(path).expect("a table");
    let rows = reader.deserialize().collect::<Result<_, _>>();
    rows.expect("rows")
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).expect("a file")
}

const BRIEF: &str = "instants = [1.2, 1.25]";

const LITTLE: [&str; 4] = ["--starts", "6", "--long-run", "2500"];

#[test]
fn all_counts_of_the_failure_map_are_in_table_and_page() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), edited("instants", BRIEF)).expect("written");
    let arguments = [&["failures", "a.toml", "--seed", "3"], &LITTLE[..]].concat();
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let out = folder.path().join("out");
    let rows: Vec<Row> = table(&out.join("failures.csv"));
    let page = read(&out.join("failures.html"));
    for closure in ["nine distances", "rigid body"] {
        for scalar in ["f64", "f32"] {
            for axis in Axis::ALL {
                let is_it =
                    |row: &&Row| (&*row.closure, &*row.scalar, row.axis) == (closure, scalar, axis);
                assert!(
                    rows.iter().any(|row| is_it(&row)),
                    "{closure} {scalar} {axis:?}"
                );
            }
        }
    }
    for row in &rows {
        assert_eq!(
            row.right + row.wrong_branch + row.no_root,
            row.trials,
            "{row:?}"
        );
        assert!(row.trials > 0 && row.mirrored <= row.wrong_branch && row.seed == 3);
        assert!(row.residual_m.is_finite(), "{row:?}");
        assert!(page.contains(&row.method), "{row:?}");
    }
    let long: Vec<LongRow> = table(&out.join("long_runs.csv"));
    let steps: Vec<u64> = long.iter().map(|row| row.steps).collect();
    assert_eq!(
        steps,
        [1000, 2000, 2500].repeat(4),
        "two methods, two number types"
    );
    let svg = read(&out.join("failures.svg"));
    assert!(svg.starts_with("<svg") && svg.ends_with("</svg>"));
    assert!(svg.contains("right 6 of 6") && svg.contains("seed 3"));
    for drawing in [&svg, &page] {
        assert!(!drawing.contains("NaN") && !drawing.contains("inf"));
    }
    let elsewhere =
        page.matches("http").count() - page.matches("http://www.w3.org/2000/svg").count();
    assert_eq!(elsewhere, 0, "the page needs no other file");
}

/// The counts of a mechanism do not depend on the unit of its file.
#[test]
fn failure_counts_do_not_depend_on_the_unit_of_length() {
    let folder = folder();
    let (whole, brief) = ("stop = 1.95\nstep = 0.05", "stop = 0.05\nstep = 0.05");
    let text = example("published_five_link.toml").replace(whole, brief);
    std::fs::write(folder.path().join("mm.toml"), text).expect("written");
    let arguments = [&["failures", "mm.toml"], &LITTLE[..]].concat();
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let rows: Vec<Row> = table(&folder.path().join("out/failures.csv"));
    let roots = rows
        .iter()
        .filter(|row| row.method == "damped Newton" && row.scalar == "f64");
    for row in roots {
        assert!(row.residual_m < 1e-14, "{row:?}");
        assert!(row.right == row.trials || row.value > 3e-3, "{row:?}");
    }
}

#[test]
fn a_motion_of_one_instant_is_refused() {
    let folder = folder();
    let instant = edited("instants", "instants = [1.0]");
    std::fs::write(folder.path().join("a.toml"), instant).expect("written");
    let output = run(folder.path(), &["failures", "a.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let message = "a.toml: a motion of one instant has no steps to try";
    assert!(text(&output.stderr).contains(message), "{output:?}");
}

#[cfg(unix)]
#[test]
fn an_interrupt_keeps_the_completed_counts() {
    use std::process::{Command, Stdio};
    use std::time::Duration;

    use super::program::command;

    // The duration of the first point depends on the machine.
    for seconds in [2, 4, 8, 16, 32] {
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
        let child = command(folder.path())
            .args(["failures", "a.toml", "--starts", "300"])
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program runs");
        std::thread::sleep(Duration::from_secs(seconds));
        let sent = Command::new("kill")
            .args(["-INT", &child.id().to_string()])
            .status();
        assert!(sent.expect("a signal").success());
        let output = child.wait_with_output().expect("the program ends");
        assert_eq!(output.status.code(), Some(130), "{output:?}");
        let rows: Vec<Row> = table(&folder.path().join("out/failures.csv"));
        let kept = format!("interrupted: {} rows were kept", rows.len());
        assert!(text(&output.stderr).contains(&kept), "{output:?}");
        if !rows.is_empty() {
            assert!(folder.path().join("out/failures.html").exists());
            return;
        }
    }
    panic!("nothing was counted in half a minute");
}
