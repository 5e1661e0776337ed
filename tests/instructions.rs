//! The instructions that a step of fixed cost executes: one number, whatever the data.
//!
//! Counted by valgrind in the release build, as it is shipped: only there the compiler has made
//! of the code what will run. The example is one of the core, so that its few dependencies are
//! all there is to build.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

const STEPS: usize = 1000;
/// What is counted, and after what the count is written. Valgrind keeps one option a pattern, so
/// that these must differ.
const COUNTED: &str = "*bounded_steps*counted_step*";
const WRITTEN_AFTER: &str = "*counted_step*";

#[test]
fn one_number_for_a_thousand_different_steps() {
    if !has_valgrind() {
        return;
    }
    let program = release_build();
    for linkage in ["attia2003", "five_link"] {
        for number in ["f64", "f32"] {
            let counts = counts(&program, &format!("{linkage}/{number}"));
            assert_eq!(counts.len(), STEPS);
            let different: BTreeSet<u64> = counts.into_iter().collect();
            println!("{linkage}/{number}: {different:?} instructions");
            assert_eq!(different.len(), 1, "{linkage}/{number}: {different:?}");
            assert!(different.iter().all(|count| *count > STEPS as u64));
        }
    }
}

/// Whether the test can be made. Where it must be, in CI, it is an error that it cannot.
fn has_valgrind() -> bool {
    if Command::new("valgrind").arg("--version").output().is_ok() {
        return true;
    }
    assert!(std::env::var_os("CI").is_none(), "no valgrind");
    // The test harness captures what eprintln! writes, but not this.
    writeln!(
        std::io::stderr(),
        "SKIPPED one_number_for_a_thousand_different_steps: there is no valgrind"
    )
    .expect("standard error");
    false
}

/// Builds the example for any processor: valgrind knows no instructions of 512 bits.
fn release_build() -> PathBuf {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .parent()
        .expect("a folder of the target's");
    let built = Command::new(env!("CARGO"))
        .args(["build", "--quiet", "--locked", "--release"])
        .args(["--package", "suspension-core", "--example", "bounded_steps"])
        .arg("--target-dir")
        .arg(target)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .env("RUSTFLAGS", "")
        .status()
        .expect("cargo runs");
    assert!(built.success());
    target.join("release/examples/bounded_steps")
}

/// The instructions of each step.
fn counts(program: &Path, linkage: &str) -> Vec<u64> {
    let folder = tempfile::tempdir().expect("a folder");
    let output = Command::new("valgrind")
        .args(["--quiet", "--tool=callgrind", "--collect-atstart=no"])
        .arg(format!("--toggle-collect={COUNTED}"))
        .arg(format!("--dump-after={WRITTEN_AFTER}"))
        .arg(format!(
            "--callgrind-out-file={}",
            folder.path().join("out").display()
        ))
        .arg(program)
        .arg(linkage)
        .output()
        .expect("valgrind runs");
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{complaint}");
    let files = std::fs::read_dir(folder.path()).expect("the folder");
    files
        .map(|file| std::fs::read_to_string(file.expect("a file").path()).expect("text"))
        // The last one is written at the end of the program.
        .filter(|dump| dump.contains("\ndesc: Trigger: --dump-after"))
        .map(|dump| {
            let summary = dump.lines().find_map(|line| line.strip_prefix("summary: "));
            summary.and_then(|n| n.parse().ok()).expect("a count")
        })
        .collect()
}
