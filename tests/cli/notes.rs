//! What the program remarks on a file that runs.

use super::program::{edited, example, folder, run, text};

/// The notes on a file.
fn notes(content: &str) -> String {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), content).expect("written");
    let output = run(folder.path(), &["motion", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    text(&output.stderr).to_owned()
}

#[test]
fn hardpoints_in_another_unit_are_remarked() {
    let millimetres = example("five_link.toml");
    assert_eq!(notes(&millimetres), "");
    let metres = millimetres.replace("unit = \"mm\"", "unit = \"m\"");
    let told = notes(&metres);
    assert!(
        told.starts_with("note: a.toml: the points are up to 537 m apart"),
        "{told}"
    );
    assert!(told.contains("unit = \"mm\""), "{told}");
}

#[test]
fn a_moved_point_that_lengths_put_elsewhere_is_remarked() {
    assert_eq!(notes(&example("attia2003.toml")), "");
    let told = notes(&edited("p8", "p8 = [-1.27, 0.345, 0.218]"));
    assert!(
        told.starts_with("note: a.toml: with [lengths]") && told.contains("`p8` 0.101 m"),
        "{told}"
    );
}
