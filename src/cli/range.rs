//! `suspension range`: its options and help.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;

use super::target;
use crate::failure::Failure;
use crate::range::{Wanted, range};

/// What `suspension range` is given.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The motion file (TOML), see suspension motion --help.
    file: PathBuf,
    /// Write every place of the curves as comma-separated values to PATH, or to standard output
    /// for `-`.
    #[arg(long, value_name = "PATH")]
    csv: Option<PathBuf>,
    /// Draw wheel-centre height over each drive's whole curve as SVG into the folder DIR.
    #[arg(long, value_name = "DIR")]
    plots: Option<PathBuf>,
}

impl Arguments {
    /// Finds the ranges.
    ///
    /// # Errors
    ///
    /// See [`Failure`].
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let Self { file, csv, plots } = self;
        let csv = csv.map(target);
        range(&Wanted { file, csv, plots }, interrupted)
    }
}

pub(super) const NOTES: &str = "\
Each drive in turn is set free, the others held as at the file's first instant, and the mechanism
is followed through the turning points of the drive, which the drive itself cannot do, until its
curve closes or another curve crosses. Printed for each drive:

  lower end, upper end   the values between which it leads the mechanism from the first instant,
                         and what ends them: a turning point, where the mechanism locks and
                         velocities grow without bound; 0 or pi, where an angle itself ends; a
                         bifurcation, where the mechanism can go either way
  motion                 when the file's motion is at an end, where it moves this drive alone
  poor                   where the transmission is poor: for a unit of the drive the free points
                         move (root of the sum of squares) more than five times as far as where in
                         the range they move least
  curve                  whether it is closed, and how often the drive turns on it

The table, one row a place, in the order along the curve:

  freed              the number of the drive that is free, from 1
  turns              1 where it turns, else 0
  each drive         in rad or the unit
  speed              how far the free points move for a unit of the drive; inf where it turns
  points             _x _y _z, in the unit
  kingpin, caster, camber, toe in rad; residual in the unit

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, 3 the first instant is out of
reach, or is a bifurcation, 130 interrupted, what was found is kept.

Example:
  suspension range examples/five_link.toml --csv curve.csv --plots plots";
