//! A program that depends on the core under another name.

use std::path::Path;
use std::process::Command;

const PROGRAM: &str = "
#![deny(warnings)]
kinematics::linkage! {
    pub mod crank {
        fixed: pin;
        free:  end;
        link arm: pin -> end;
        drive turn:  angle(pin -> end, z);
        drive slide: end.x;
    }
}

fn main() {
    use kinematics::Build;
    use kinematics::nalgebra::Vector3;
    let design = crank::Points {
        pin: Vector3::zeros(),
        end: Vector3::new(0.0, 0.3, 0.4),
    };
    let model = crank::Model::new(&design).unwrap();
    assert_eq!(model.lengths().arm, 0.5);
}
";

#[test]
fn a_listing_names_the_core_as_the_program_does() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let manifest = format!(
        r#"[package]
name = "renamed"
edition = "2024"
[[bin]]
name = "renamed"
path = "main.rs"
[dependencies]
kinematics = {{ package = "suspension-core", path = {:?} }}
[workspace]
"#,
        here.join("suspension-core")
    );
    std::fs::write(folder.path().join("Cargo.toml"), manifest).expect("written");
    std::fs::write(folder.path().join("main.rs"), PROGRAM).expect("written");
    std::fs::copy(here.join("Cargo.lock"), folder.path().join("Cargo.lock")).expect("copied");
    let ran = Command::new(env!("CARGO"))
        .current_dir(folder.path())
        .args(["run", "--quiet", "--offline", "--target-dir"])
        .arg(Path::new(env!("CARGO_TARGET_TMPDIR")).join("reader"))
        .output()
        .expect("cargo runs");
    let message = String::from_utf8_lossy(&ran.stderr);
    assert!(ran.status.success(), "{message}");
}
