//! The program, run as a user runs it.

mod accuracy;
mod chart;
mod failures;
#[path = "../../../tests/cli/program.rs"]
mod program;

#[test]
fn a_motion_led_by_a_measure_is_refused() {
    let folder = program::folder();
    let led = program::example("five_link_height.toml");
    std::fs::write(folder.path().join("a.toml"), led).expect("written");
    for command in ["chart", "failures"] {
        let output = program::run(folder.path(), &[command, "a.toml"]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let message = program::text(&output.stderr);
        let expected = format!(
            "`height` is a measure that prescribes the motion; suspension-laboratory {command} needs"
        );
        assert!(message.contains(&expected), "{output:?}");
    }
    let files = std::fs::read_dir(folder.path()).expect("a folder").count();
    assert_eq!(files, 1);
}

/// The program that is run.
const PROGRAM: &str = env!("CARGO_BIN_EXE_suspension-laboratory");
