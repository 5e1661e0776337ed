//! A user who interrupts a study.

use super::super::program::{folder, text};
use super::super::signals::interrupted_by;
use super::{corner, parsed};

#[test]
fn an_interrupted_study_keeps_the_values_that_are_done() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), corner("")).expect("written");
    let arguments = [
        "vary",
        "a.toml",
        "rack.z=-0.006:0.006:999",
        "--of",
        "toe",
        "--csv",
        "-",
        "--html",
        "v.html",
    ];
    let output = interrupted_by("-INT", folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(130), "{output:?}");
    let message = text(&output.stderr);
    assert!(
        message.contains("a.toml: interrupted; the last "),
        "{message}"
    );
    let table = parsed(&output.stdout);
    assert!(!table.is_empty());
    assert!(table.iter().all(|(_, numbers)| numbers.len() == 3));
}

#[test]
fn the_page_of_an_interrupted_study_says_that_values_are_missing() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), corner("")).expect("written");
    let arguments = [
        "vary",
        "a.toml",
        "rack.z=-0.006:0.006:999",
        "--of",
        "toe",
        "--html",
        "-",
    ];
    let output = interrupted_by("-INT", folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(130), "{:?}", output.stderr);
    let page = text(&output.stdout);
    assert!(page.contains("The study is not complete: </strong>interrupted; the last "));
}
