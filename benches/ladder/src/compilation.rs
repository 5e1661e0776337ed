//! A ladder compiled and run as a user's crate would be.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use crate::listing;

/// The program that drives a ladder.
const PROGRAM: &str = include_str!("../template/main.rs");

/// A crate that is rewritten for each ladder, with its dependencies compiled.
pub(crate) struct Workshop {
    folder: PathBuf,
    /// Seconds that an empty program takes to check and to compile.
    empty: [f64; 2],
}

/// What compiling a ladder takes, and a step of it.
pub(crate) struct Compilation {
    pub(crate) check_s: f64,
    pub(crate) release_s: f64,
    pub(crate) step_us: f64,
}

impl Workshop {
    /// In a folder of its own under `out`.
    pub(crate) fn new(out: &Path) -> Result<Self, Box<dyn Error>> {
        let folder = out.join("crate");
        fs::create_dir_all(folder.join("src"))?;
        let core = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../../suspension-core")
            .canonicalize()?;
        fs::write(folder.join("Cargo.toml"), manifest(&core))?;
        let mut workshop = Self {
            folder,
            empty: [0.0; 2],
        };
        // The first time compiles the dependencies.
        workshop.build("fn main() {}")?;
        workshop.empty = workshop.build("fn main() {}")?;
        Ok(workshop)
    }

    pub(crate) fn compile(&self, bodies: usize) -> Result<Compilation, Box<dyn Error>> {
        fs::write(self.folder.join("src/listing.rs"), listing::listing(bodies))?;
        let [check_s, release_s] = self.build(PROGRAM)?;
        Ok(Compilation {
            check_s: check_s - self.empty[0],
            release_s: release_s - self.empty[1],
            step_us: self.run()? / 1000.0,
        })
    }

    /// Checks and compiles the program; returns the seconds of both.
    fn build(&self, program: &str) -> Result<[f64; 2], Box<dyn Error>> {
        fs::write(self.folder.join("src/main.rs"), program)?;
        let check = self.cargo(&["check"])?;
        Ok([check, self.cargo(&["build", "--release"])?])
    }

    fn cargo(&self, arguments: &[&str]) -> Result<f64, Box<dyn Error>> {
        let start = Instant::now();
        let output = Command::new(env!("CARGO"))
            .args(arguments)
            .arg("--quiet")
            .env("CARGO_TARGET_DIR", "target")
            .current_dir(&self.folder)
            .output()?;
        if output.status.success() {
            Ok(start.elapsed().as_secs_f64())
        } else {
            Err(String::from_utf8_lossy(&output.stderr).into())
        }
    }

    /// Runs the program; returns the nanoseconds of a step.
    fn run(&self) -> Result<f64, Box<dyn Error>> {
        let output = Command::new(self.folder.join("target/release/ladder")).output()?;
        if !output.status.success() {
            return Err(String::from_utf8_lossy(&output.stderr).into());
        }
        Ok(String::from_utf8(output.stdout)?.trim().parse()?)
    }
}

fn manifest(core: &Path) -> String {
    format!(
        "[package]\nname = \"ladder\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n\n\
         [dependencies]\nsuspension-core = {{ path = {core:?} }}\n"
    )
}
