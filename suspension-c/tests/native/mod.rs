//! Libraries as users build them, and programs that C compilers link with them.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Returns the folder of the repository.
pub(crate) fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .expect("the crate lies in the repository")
}

/// Returns whether there is such a compiler. In CI, where there must be one, its absence is an error.
pub(crate) fn has(compiler: &str, test: &str) -> bool {
    if Command::new(compiler).arg("--version").output().is_ok() {
        return true;
    }
    assert!(std::env::var_os("CI").is_none(), "no {compiler}");
    // The test harness captures what eprintln! writes, but not this.
    writeln!(std::io::stderr(), "SKIPPED {test}: there is no {compiler}").expect("standard error");
    false
}

/// Returns the folder of an example of this crate. `cargo test --workspace` has built it with the features
/// of the whole workspace, with which elementary functions are those of C. `.ci/c_interface.sh` tests what
/// users link.
pub(crate) fn example(name: &str) -> PathBuf {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .parent()
        .expect("a folder of the target's");
    run(Command::new(env!("CARGO"))
        .args(["build", "--quiet", "--locked", "--workspace"])
        .args(["--example", name])
        .arg("--target-dir")
        .arg(target)
        .current_dir(root()));
    target.join("debug/examples")
}

/// Compiles a program of `examples/c`, with every warning an error.
pub(crate) fn compile(source: &str, options: &[&str], library: &Path, program: &Path) {
    run(Command::new("cc")
        .args([
            "-std=c11",
            "-O2",
            "-Wall",
            "-Wextra",
            "-Werror",
            "-ffp-contract=off",
        ])
        .arg("-I")
        .arg(root().join("suspension-c/include"))
        .args(options)
        .arg(root().join("examples/c").join(source))
        .arg(library)
        .arg("-o")
        .arg(program)
        // In a build of the whole workspace elementary functions are those of C.
        .arg("-lm"));
}

/// Runs a command that must succeed, and returns what it prints.
pub(crate) fn run(command: &mut Command) -> String {
    let output = command.output().expect("a program that can be started");
    let complaint = String::from_utf8_lossy(&output.stderr);
    let printed = String::from_utf8(output.stdout).expect("text");
    assert!(output.status.success(), "{command:?}: {printed}{complaint}");
    printed
}
