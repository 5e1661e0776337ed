//! The progress that a terminal shows during long work.

use std::process::Command;

use super::program::{CORNER, folder, text};

/// A pseudo-terminal, of `script`, on which the program bakes a surface whose tolerance no layout of patches meets.
#[test]
fn a_terminal_shows_that_a_surface_is_being_baked() {
    if Command::new("script").arg("--version").output().is_err() {
        println!("SKIPPED a_terminal_shows_that_a_surface_is_being_baked: there is no script");
        return;
    }
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), CORNER).expect("written");
    let program = env!("CARGO_BIN_EXE_suspension");
    let bake = format!(
        "{program} bake a.toml --tolerance 1e-14 --points all --drive bump=0.25:0.35 --drive steer=0.33:0.35"
    );
    let output = Command::new("script")
        .args(["-qec", &bake, "/dev/null"])
        .current_dir(folder.path())
        .output()
        .expect("script runs");
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let shown = text(&output.stdout);
    assert!(shown.contains("baking (1s)"), "{shown}");
    assert!(shown.contains("cannot be baked"), "{shown}");
}
