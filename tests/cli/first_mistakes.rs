//! Mistakes of a first motion file: each message says what to write instead.

mod in_line;
mod missing;
mod mistyped;
mod notations;
mod several;
mod time;
mod units;

use super::program::{folder, run, text};

/// Returns the message for files that a command is given, the first of which it reads.
fn refusal(command: &str, files: &[(&str, &str)], options: &[&str]) -> String {
    let folder = folder();
    for (name, content) in files {
        std::fs::write(folder.path().join(name), content).expect("written");
    }
    let output = run(folder.path(), &[&[command, files[0].0], options].concat());
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    text(&output.stderr).trim_end().to_owned()
}
