//! Baked files.

mod along;
mod branch;
mod c;
mod contents;
mod kept;
mod languages;
mod orders;
mod surfaces;
mod wheels;

use std::path::Path;

use super::program::{example, run, text};

/// A range of theta that can be baked.
const RANGE: [&str; 4] = ["--from", "0.75", "--to", "2"];

fn baked(folder: &Path, arguments: &[&str]) -> String {
    baked_of("published_five_link.toml", folder, arguments)
}

/// Returns the baked file of an example, which is `a.toml` in the folder.
fn baked_of(name: &str, folder: &Path, arguments: &[&str]) -> String {
    std::fs::write(folder.join("a.toml"), example(name)).expect("written");
    let fixed = ["bake", "a.toml", "--out", "wheel_by_theta"];
    let output = run(folder, &[&fixed, arguments].concat());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    std::fs::read_to_string(folder.join("wheel_by_theta")).expect("a file")
}
