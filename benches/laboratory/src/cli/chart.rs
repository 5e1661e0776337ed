//! `suspension-laboratory chart`: its options and help.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;

use crate::chart::survey::Effort;
use crate::chart::{Wanted, chart};
use suspension::failure::Failure;

/// What `chart` is given.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The motion file (TOML), see suspension motion --help; without one the published motion.
    file: Option<PathBuf>,
    /// Write the table to PATH instead of chart.csv in the folder.
    #[arg(long, value_name = "PATH")]
    csv: Option<PathBuf>,
    /// The folder for chart.csv, chart.svg and chart.html, where rivals.csv is taken in.
    #[arg(long, value_name = "DIR", default_value = "out")]
    folder: PathBuf,
    /// Two time steps and few repetitions: some seconds, for a look.
    #[arg(long)]
    quick: bool,
    /// Measure each time ROUNDS times.
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..))]
    rounds: Option<u32>,
}

impl Arguments {
    /// Makes the chart.
    ///
    /// # Errors
    ///
    /// See [`Failure`].
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let Self {
            file,
            csv,
            folder,
            quick,
            rounds,
        } = self;
        let mut effort = if quick {
            Effort::quick()
        } else {
            Effort::full()
        };
        if let Some(rounds) = rounds {
            effort.rounds = rounds as usize;
        }
        let wanted = Wanted {
            file,
            csv,
            folder,
            effort,
        };
        chart(&wanted, interrupted)
    }
}

pub(super) const NOTES: &str = "\
Each method goes through the motion in steps of 0.1, 1, 5 and 20 ms, from the file's first instant
to its last (the published motion: to 1.9 s). Its error is the worst of any coordinate of a free
point, against a solution in double-double numbers at the same values of the drives. All solve
about an origin among the points; models in f32 are computed in f64 and rounded once. Its time is
the median over many rounds of the time of single steps spread over the motion, of one suspension.

The table, one row a method, number type, lanes, time step and what is computed: position;
velocity and position; acceleration, velocity and position. Columns:

  method, scalar, lanes       as in the figures
  step_s                      time step, s
  outputs                     position, velocity or acceleration, each with the ones before
  nanoseconds, spread_ns      median time of a step, and what the middle half of the times span
  error_position_m, error_velocity_m_s, error_acceleration_m_s2
                              worst errors, in metres whatever the file's unit; empty where
                              not computed

Where FOLDER holds rivals.csv, the table that benches/rivals writes, it is drawn too.

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, 3 the mechanism has no motion,
130 interrupted, what was measured is kept.";
