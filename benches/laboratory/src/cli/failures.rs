//! `suspension-laboratory failures`: its options and help.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;

use crate::failures::survey::Effort;
use crate::failures::{Wanted, failures};
use suspension::failure::Failure;

/// What `failures` is given.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The motion file (TOML), see suspension motion --help.
    file: PathBuf,
    /// The folder for failures.csv, failures.svg, failures.html and long_runs.csv.
    #[arg(long, value_name = "DIR", default_value = "out")]
    out: PathBuf,
    /// Trials behind each point; of runs through the whole motion a tenth, in short steps fewer.
    #[arg(long, value_name = "N", default_value_t = 400, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    starts: u32,
    /// Where the random numbers begin: the same seed gives the same counts.
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// Steps of the long runs, of a millisecond each; 0 for none.
    #[arg(long, value_name = "STEPS", default_value_t = 10_000_000)]
    long_run: u64,
}

impl Arguments {
    /// Draws the map.
    ///
    /// # Errors
    ///
    /// See [`Failure`].
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let wanted = Wanted {
            file: self.file,
            folder: self.out,
            effort: Effort {
                starts: self.starts as usize,
                long_run: self.long_run,
                seed: self.seed,
            },
        };
        failures(&wanted, interrupted)
    }
}

pub(super) const NOTES: &str = "\
Each method is tried from starts with normal noise on every coordinate of a free point (1 mm to
0.4 m), through the whole motion in steps of 0.1 ms to 1 s, and in one step that ends 0.1 to 1e-12
(rad or m) before a turning point of the first drive. A trial is right where no coordinate
is off by more than 0.1 mm from the motion followed in fine steps, or beside a turning point by half
the way to the other configuration; wrong where the method gives out another configuration (or one
that drifted as far) as its result; without root where it says that it finds none. A five-link
suspension is tried with its knuckle closed by nine distances and as a rigid body.

failures.csv, one row a method, closure, number type and point:

  axis, value, unit           start_noise in m, step in s, turning_point in rad or m
  method, closure, scalar     as in the figures
  trials, right, wrong_branch, mirrored, no_root
                              counts; of the wrong ones those with a mirrored body
  residual_m                  the largest residual of a result, m: what lengths are off
  seed                        of the random numbers

long_runs.csv: steps of 1 ms back and forth through the motion by the tracker and by integrated
velocities, one row wherever their number has doubled or so:

  method, closure, scalar     as above
  steps                       from the beginning
  drift_m                     the largest residual after any step since the row before, m
  iterations_a_step           since the row before
  ended                       why the run ended there, if it did not make all its steps

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, 3 the mechanism has no motion,
130 interrupted, what was counted is kept.

Example:
  suspension-laboratory failures examples/attia2003.toml --out out --starts 1000 --seed 7";
