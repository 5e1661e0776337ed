//! Where results are written.

use super::program::{example, folder, run, text};

#[test]
fn an_unwritable_result_is_exit_code_1() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    std::fs::write(folder.path().join("file"), "").expect("written");
    let arguments = ["motion", "a.toml", "--csv", "file/a.csv"];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(1));
    let message = text(&output.stderr);
    assert_eq!(message.lines().count(), 1);
    assert!(
        message.starts_with("file/a.csv: cannot be written"),
        "{message}"
    );
}
