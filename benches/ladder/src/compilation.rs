//! A ladder compiled and run as a user's crate would be.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use crate::listing;
use crate::median::median;

/// The program that drives a ladder.
const PROGRAM: &str = include_str!("../template/main.rs");

/// The number of builds for a median.
const REPEATS: usize = 3;

/// A crate that is rewritten for each ladder, with its dependencies compiled.
pub(crate) struct Workshop {
    folder: PathBuf,
    /// The effort of checking and of compiling an empty program.
    empty: [Effort; 2],
}

/// The effort of compiling a ladder, and the time of a step.
pub(crate) struct Compilation {
    pub(crate) check: Effort,
    pub(crate) release: Effort,
    pub(crate) step_us: f64,
}

/// Seconds that a build takes, and those that processors spend on it.
#[derive(Clone, Copy, Default)]
pub(crate) struct Effort {
    pub(crate) wall_s: f64,
    pub(crate) cpu_s: f64,
}

impl Effort {
    fn beyond(self, empty: Self) -> Self {
        Self {
            wall_s: self.wall_s - empty.wall_s,
            cpu_s: self.cpu_s - empty.cpu_s,
        }
    }
}

impl Workshop {
    /// Compiles in a separate folder under `out`.
    pub(crate) fn new(out: &Path) -> Result<Self, Box<dyn Error>> {
        let folder = out.join("crate");
        fs::create_dir_all(folder.join("src"))?;
        let core = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../../suspension-core")
            .canonicalize()?;
        fs::write(folder.join("Cargo.toml"), manifest(&core))?;
        let mut workshop = Self {
            folder,
            empty: [Effort::default(); 2],
        };
        // The first of the repeats compiles the dependencies.
        workshop.empty = workshop.build("fn main() {}")?;
        Ok(workshop)
    }

    pub(crate) fn compile(&self, bodies: usize) -> Result<Compilation, Box<dyn Error>> {
        fs::write(self.folder.join("src/listing.rs"), listing::listing(bodies))?;
        let [check, release] = self.build(PROGRAM)?;
        Ok(Compilation {
            check: check.beyond(self.empty[0]),
            release: release.beyond(self.empty[1]),
            step_us: self.run()? / 1000.0,
        })
    }

    /// Checks and compiles the program.
    fn build(&self, program: &str) -> Result<[Effort; 2], Box<dyn Error>> {
        let check = self.cargo(program, &["check"])?;
        Ok([check, self.cargo(program, &["build", "--release"])?])
    }

    fn cargo(&self, program: &str, arguments: &[&str]) -> Result<Effort, Box<dyn Error>> {
        let (mut wall_s, mut cpu_s) = ([0.0; REPEATS], [0.0; REPEATS]);
        for (wall_s, cpu_s) in wall_s.iter_mut().zip(&mut cpu_s) {
            // Written anew, the program is compiled anew.
            fs::write(self.folder.join("src/main.rs"), program)?;
            let (start, cpu_before) = (Instant::now(), cpu_of_children()?);
            let output = Command::new(env!("CARGO"))
                .args(arguments)
                .arg("--quiet")
                .env("CARGO_TARGET_DIR", "target")
                .env("CARGO_INCREMENTAL", "0")
                .current_dir(&self.folder)
                .output()?;
            if !output.status.success() {
                return Err(String::from_utf8_lossy(&output.stderr).into());
            }
            *wall_s = start.elapsed().as_secs_f64();
            *cpu_s = cpu_of_children()? - cpu_before;
        }
        Ok(Effort {
            wall_s: median(wall_s),
            cpu_s: median(cpu_s),
        })
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

/// Returns the processor seconds of all builds so far.
#[cfg(unix)]
fn cpu_of_children() -> std::io::Result<f64> {
    use nix::sys::resource::{UsageWho, getrusage};
    use nix::sys::time::TimeVal;

    let usage = getrusage(UsageWho::RUSAGE_CHILDREN)?;
    let seconds = |time: TimeVal| time.tv_sec() as f64 + 1e-6 * time.tv_usec() as f64;
    Ok(seconds(usage.user_time()) + seconds(usage.system_time()))
}

#[cfg(not(unix))]
fn cpu_of_children() -> std::io::Result<f64> {
    let message = "the processor time of a build is known on Unix only";
    Err(std::io::Error::new(
        std::io::ErrorKind::Unsupported,
        message,
    ))
}

fn manifest(core: &Path) -> String {
    format!(
        "[package]\nname = \"ladder\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n\n\
         [dependencies]\nsuspension-core = {{ path = {core:?} }}\n"
    )
}
