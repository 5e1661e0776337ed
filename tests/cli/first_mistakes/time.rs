//! Steps and stops that do not fit.

use super::super::program::{CORNER, folder, run, text};

#[test]
fn a_stop_between_two_steps_is_noted() {
    let folder = folder();
    let notes_with = |step: &str| {
        let file = CORNER.replace(
            "instants = [0.0]",
            &format!("start = 0, stop = 1, step = {step}"),
        );
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let output = run(folder.path(), &["motion", "a.toml"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        text(&output.stderr).to_owned()
    };
    assert_eq!(notes_with("0.1"), "");
    assert_eq!(
        notes_with("0.3"),
        "note: a.toml: the motion ends at t = 0.9 s: its stop at 1 s is not a whole number of steps of 0.3 s\n"
    );
}

/// In binary the motion is shorter than its one step: 0.3 - 0.1 < 0.2.
#[test]
fn one_step_as_long_as_the_motion_reaches_its_stop() {
    let folder = folder();
    let time = "time = { start = 0.1, stop = 0.3, step = 0.2 }";
    let file = CORNER.replace("time = { instants = [0.0] }", time);
    assert!(file.contains(time), "{file}");
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["motion", "a.toml", "--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert_eq!(text(&output.stdout).lines().count(), 3);
}
