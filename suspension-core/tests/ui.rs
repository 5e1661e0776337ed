//! Each mistake in a listing is reported on the user's own token, with what to write instead.
//!
//! The programs are compiled with the core that this test is linked with, of which cargo tells the place. (The crate `trybuild`
//! builds the core and all it depends on twice more.)

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

#[test]
fn ui() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/ui");
    let core = core();
    let files = std::fs::read_dir(&folder).expect("the folder of cases");
    let mut cases: Vec<PathBuf> = files.map(|file| file.expect("a file").path()).collect();
    cases.retain(|file| file.extension().is_some_and(|extension| extension == "rs"));
    assert!(cases.len() > 10, "{cases:?}");
    for case in cases {
        let output = compiled(&case, &core);
        assert!(!output.status.success(), "{} compiles", case.display());
        let found = String::from_utf8(output.stderr).expect("text");
        is_as_kept(&found, &case.with_extension("stderr"));
    }
}

/// The library of the core that this test is linked with.
fn core() -> PathBuf {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent();
    let output = Command::new(env!("CARGO"))
        .args(["test", "--quiet", "--locked", "--workspace", "--test", "ui"])
        .args(["--no-run", "--message-format=json", "--target-dir"])
        .arg(target.expect("a folder of the target's"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{output:?}");
    let messages = String::from_utf8(output.stdout).expect("text");
    let mut messages = messages
        .lines()
        .map(|line| serde_json::from_str::<Value>(line).expect("JSON"));
    let core = messages.find(|message| message["target"]["name"] == "suspension_core");
    let core = core.expect("this test depends on the core");
    let mut files = core["filenames"].as_array().into_iter().flatten();
    let library = files.find_map(|file| file.as_str().filter(|file| file.ends_with(".rlib")));
    library.expect("a library").into()
}

/// What the compiler says of a program.
fn compiled(case: &Path, core: &Path) -> Output {
    let beside = core.parent().expect("a folder").display();
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()))
        .args([
            "--edition=2024",
            "--emit=metadata",
            "--color=never",
            "--diagnostic-width=140",
        ])
        .arg(format!("--extern=suspension_core={}", core.display()))
        .arg(format!("-Ldependency={beside}"))
        .args(["--out-dir", env!("CARGO_TARGET_TMPDIR")])
        .arg(case.strip_prefix(here).expect("a file of this package"))
        .current_dir(here)
        .output()
        .expect("the compiler runs")
}

/// Compares messages with those that are kept.
fn is_as_kept(found: &str, file: &Path) {
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some_and(|value| value == "1") {
        std::fs::write(file, found).expect("written");
    }
    let kept = std::fs::read_to_string(file).unwrap_or_default();
    assert!(
        found == kept,
        "{} has changed; take it over with `UPDATE_SNAPSHOTS=1 cargo test -p suspension-core --test ui` and read the \
         difference:\n{found}",
        file.display()
    );
}
