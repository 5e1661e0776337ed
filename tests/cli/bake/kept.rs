//! Rust files as `suspension bake` writes them: that they are modules here says that they compile, also under strict lints.
#![warn(clippy::pedantic)]
#![allow(unreachable_pub, reason = "they are for crates of any kind")]

use std::path::Path;

#[rustfmt::skip]
pub(super) mod wheel_by_bump_and_steer;
#[rustfmt::skip]
pub(super) mod wheel_by_damper;
#[rustfmt::skip]
#[path = "../../firmware/controller/src/wheel_by_theta.rs"]
pub(super) mod wheel_by_theta;

/// Compares a baked Rust file with the file that is a module here.
pub(super) fn is_as_kept(baked: &str, name: &str) {
    let kept = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/cli/bake/kept")
        .join(name);
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some_and(|value| value == "1") {
        std::fs::write(&kept, baked).expect("written");
    }
    assert_eq!(
        std::fs::read_to_string(&kept).expect("a source file"),
        baked,
        "what is baked has changed; take it over with `UPDATE_SNAPSHOTS=1 cargo test --test cli bake::`"
    );
}
