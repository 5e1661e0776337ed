//! A user who interrupts a study.

use std::process::Output;

use super::super::program::{folder, text};
use super::super::signals::interrupted_by;
use super::{corner, parsed};

/// Interrupts a study of many values with these outputs.
fn interrupted(outputs: &[&str]) -> Output {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), corner("")).expect("written");
    let study = ["vary", "a.toml", "rack.z=-0.006:0.006:999", "--of", "toe"];
    let output = interrupted_by("-INT", folder.path(), &[&study, outputs].concat());
    assert_eq!(output.status.code(), Some(130), "{:?}", output.stderr);
    output
}

#[test]
fn an_interrupted_study_keeps_the_values_that_are_done() {
    let output = interrupted(&["--csv", "-", "--html", "v.html"]);
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
    let output = interrupted(&["--html", "-"]);
    let page = text(&output.stdout);
    assert!(page.contains("The study is not complete: </strong>interrupted; the last "));
}
