//! The instructions that a step of fixed cost executes: one number, whatever the data.
//!
//! Counted by valgrind in the release build, the code that users run.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

const STEPS: usize = 1000;
const EXAMPLE: &str = "steps_of_fixed_cost";
/// The steps of the example. `avx2` is one lane of `Lanes`; on a processor without these instructions it runs as
/// `five_link/f64`.
const STEPPED: [&str; 5] = [
    "attia2003/f64",
    "attia2003/f32",
    "five_link/f64",
    "five_link/f32",
    "five_link/f64/avx2",
];
/// The counted function, and the one after which the count is written. Valgrind accepts one option per pattern, so these
/// must differ.
const COUNTED: &str = "*steps_of_fixed_cost*counted_step*";
const WRITTEN_AFTER: &str = "*counted_step*";

#[test]
fn a_bounded_step_takes_the_same_instructions_for_any_data() {
    if !has_valgrind() {
        return;
    }
    let program = release_build();
    for stepped in STEPPED {
        let counts = counts(&program, stepped);
        assert_eq!(counts.len(), STEPS);
        let different: BTreeSet<u64> = counts.into_iter().collect();
        println!("{stepped}: {different:?} instructions");
        assert_eq!(different.len(), 1, "{stepped}: {different:?}");
        assert!(different.iter().all(|count| *count > STEPS as u64));
    }
}

/// Returns whether valgrind is there. In CI, where it must be, its absence is an error.
fn has_valgrind() -> bool {
    if Command::new("valgrind").arg("--version").output().is_ok() {
        return true;
    }
    assert!(std::env::var_os("CI").is_none(), "no valgrind");
    // The test harness captures what eprintln! writes, but not this.
    writeln!(
        std::io::stderr(),
        "SKIPPED a_bounded_step_takes_the_same_instructions_for_any_data: there is no valgrind"
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
        .args(["--package", "suspension-lanes", "--example", EXAMPLE])
        .arg("--target-dir")
        .arg(target)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .env("RUSTFLAGS", "")
        .status()
        .expect("cargo runs");
    assert!(built.success());
    target.join("release/examples").join(EXAMPLE)
}

/// The instructions of each step.
fn counts(program: &Path, stepped: &str) -> Vec<u64> {
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
        .arg(stepped)
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
