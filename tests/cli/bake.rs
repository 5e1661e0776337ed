//! Baked files.

mod along;
mod contents;
mod languages;
mod orders;
mod surfaces;

use std::path::Path;

use super::program::{example, run, text};

/// A range of theta that can be baked.
const RANGE: [&str; 4] = ["--from", "0.75", "--to", "2"];

fn baked(folder: &Path, arguments: &[&str]) -> String {
    std::fs::write(folder.join("a.toml"), example("published_five_link.toml")).expect("written");
    let fixed = ["bake", "a.toml", "--output", "wheel_by_theta"];
    let output = run(folder, &[&fixed, arguments].concat());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    std::fs::read_to_string(folder.join("wheel_by_theta")).expect("a file")
}
