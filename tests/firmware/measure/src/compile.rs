//! Builds the firmware and the archive of its calls.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};

use crate::target::Target;

/// The workspace of the firmware.
pub(crate) fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The files built for a target.
pub(crate) struct Built {
    /// The loop, to be run.
    pub firmware: PathBuf,
    /// The archive of the calls: it is not linked, so that every function has its own section.
    pub archive: PathBuf,
}

/// Has the firmware built from the versions that the root's workspace is tested with.
pub(crate) fn take_versions() -> Result<()> {
    let versions = workspace().join("../../Cargo.lock");
    std::fs::copy(&versions, workspace().join("Cargo.lock"))
        .with_context(|| versions.display().to_string())?;
    Ok(())
}

/// Builds the files for a target in a separate folder.
pub(crate) fn compile(target: &Target) -> Result<Built> {
    let linker = linker()?;
    let config = |key: &str, value: &str| format!("target.{}.{key}={value}", target.triple);
    let mut flags = vec!["-Zemit-stack-sizes"];
    flags.extend(target.flags);
    // One folder for all targets: the macro and its dependencies are built once.
    let folder = workspace().join("target");
    let built = folder.join(target.name);
    let mut command = Command::new("rustup");
    command
        .args(["run", "debian", "cargo", "build", "--quiet", "--release"])
        .args(["--package", "controller", "--package", "entries"])
        .args(["--target", target.triple, "--target-dir"])
        .arg(&folder)
        .args(["-Zunstable-options", "--artifact-dir"])
        .arg(&built)
        .args(["--config", &config("rustflags", &format!("{flags:?}"))])
        .args(["--config", &config("linker", &format!("{linker:?}"))])
        .current_dir(workspace())
        // Required by -Z.
        .env("RUSTC_BOOTSTRAP", "1");
    if target.has_doubles {
        command.args(["--features", "controller/f64"]);
    }
    if target.has_rooms {
        command.args(["--features", "entries/rooms"]);
    }
    let status = command.status().context("rustup")?;
    ensure!(status.success(), "{}: the build fails", target.name);
    Ok(Built {
        firmware: built.join("controller"),
        archive: built.join("libentries.a"),
    })
}

/// The linker that comes with the active toolchain.
fn linker() -> Result<PathBuf> {
    let print = |what: &str| -> Result<String> {
        let output = Command::new("rustc").args(["--print", what]).output()?;
        Ok(String::from_utf8(output.stdout)?.trim().to_owned())
    };
    let (sysroot, host) = (print("sysroot")?, print("host-tuple")?);
    Ok(Path::new(&sysroot).join(format!("lib/rustlib/{host}/bin/rust-lld")))
}
