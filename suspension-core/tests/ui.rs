//! Each mistake in a listing is reported on the user's own token, with what to write instead; and the core compiles without
//! `linkage!`.
//!
//! The programs are linked with the libraries that this test is linked with, whose paths cargo prints. (The crate
//! `trybuild` builds the core and all it depends on twice more.)

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

#[test]
fn compiler_messages_match_their_snapshots() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/ui");
    let core = Libraries::built().of("suspension_core");
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

/// Only the message is compared: the compiler's additions name places in the core, which change.
#[test]
fn a_listing_without_positions_is_refused_with_what_to_state() {
    let core = Libraries::built().of("suspension_core");
    let manifest_folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let output = compiled(
        &manifest_folder.join("tests/ui/of_traits/design_without_positions.rs"),
        &core,
    );
    let found = String::from_utf8(output.stderr).expect("text");
    for expected in [
        "error[E0277]: the listing does not state where each of its points is in the design",
        "needs `at [x, y, z]` behind every chassis point, free point and marker",
        "state the missing positions, or start from the program's own: `Corner::new(&Points { ... })`",
    ] {
        assert!(found.contains(expected), "{found}");
    }
}

#[test]
fn the_core_compiles_without_its_macro() {
    let libraries = Libraries::built();
    let dependencies = ["libm", "nalgebra", "num_traits"].map(|name| (name, libraries.of(name)));
    let externs = dependencies
        .each_ref()
        .map(|(name, library)| (*name, library.as_path()));
    let output = compiler(&externs)
        .args(["--crate-type=lib", "--deny=warnings"])
        .args([
            "--check-cfg=cfg(test)",
            "--check-cfg=cfg(feature, values(\"macros\"))",
        ])
        .arg("src/lib.rs")
        .output()
        .expect("the compiler runs");
    assert!(output.status.success(), "{output:?}");
}

/// The libraries that this test is linked with: what cargo says of each.
struct Libraries(Vec<Value>);

impl Libraries {
    fn built() -> Self {
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
        let messages = messages.lines().map(serde_json::from_str);
        Self(messages.collect::<Result<_, _>>().expect("JSON"))
    }

    fn of(&self, name: &str) -> PathBuf {
        let of_library = |message: &&Value| message["target"]["name"] == name;
        let files = self.0.iter().filter(of_library);
        let mut files = files
            .filter_map(|message| message["filenames"].as_array())
            .flatten();
        let library = files.find_map(|file| file.as_str().filter(|file| file.ends_with(".rlib")));
        library.expect("this test depends on the library").into()
    }
}

/// The output of the compiler for a program.
fn compiled(case: &Path, core: &Path) -> Output {
    let manifest_folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    compiler(&[("suspension_core", core)])
        .args(["--color=never", "--diagnostic-width=140"])
        .arg(
            case.strip_prefix(manifest_folder)
                .expect("a file of this package"),
        )
        .output()
        .expect("the compiler runs")
}

/// The compiler, which checks what is linked with some libraries.
fn compiler(libraries: &[(&str, &Path)]) -> Command {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let mut compiler = Command::new(rustc);
    for (name, library) in libraries {
        let beside = library.parent().expect("a folder").display();
        compiler
            .arg(format!("--extern={name}={}", library.display()))
            .arg(format!("-Ldependency={beside}"));
    }
    compiler
        .args(["--edition=2024", "--emit=metadata"])
        .args(["--out-dir", env!("CARGO_TARGET_TMPDIR")])
        .current_dir(env!("CARGO_MANIFEST_DIR"));
    compiler
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
