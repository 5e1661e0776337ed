//! The command line's options and help.

mod assemblies;
mod bake;
mod range;

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::{Parser, Subcommand};

use crate::failure::Failure;
use crate::job::{self, Wanted};
use crate::output::csv_file::Target;

/// Suspension kinematics: positions, velocities and accelerations of a driven suspension.
///
/// Without a command, solves the multi-link five-point suspension of Attia 2003 over its
/// published motion, prints the paper's Tables 2 and 3 beside our results, and writes
/// out/attia2003.csv, out/attia2003_height.svg (its Fig. 4) and out/attia2003_angles.svg (Fig. 5).
#[derive(Debug, Parser)]
#[command(name = "suspension", version, verbatim_doc_comment, after_long_help = NOTES)]
pub struct Options {
    /// What to do instead of the published motion.
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Solves the motion that a file describes.
    ///
    /// Without --csv and --plots, prints a summary.
    #[command(after_long_help = MOTION_NOTES)]
    Motion {
        /// The motion file (TOML): linkage, points, lengths, instants, drives.
        file: PathBuf,
        /// Write every row as comma-separated values to PATH, or to standard output for `-`. Missing
        /// folders are made.
        #[arg(long, value_name = "PATH")]
        csv: Option<PathBuf>,
        /// Draw wheel-centre height, kingpin and camber angle as SVG into the folder DIR.
        #[arg(long, value_name = "DIR")]
        plots: Option<PathBuf>,
    },
    /// Lists all assemblies of a file's mechanism at values of its drive.
    ///
    /// Also says how sure it is that the list is complete.
    #[command(after_long_help = assemblies::NOTES)]
    Assemblies(assemblies::Arguments),
    /// Bakes the motion of a file along one drive into a source file.
    ///
    /// A piecewise polynomial within a tolerance of the solver, looked up in a few nanoseconds:
    /// for scenes of many vehicles, and for controllers.
    #[command(after_long_help = bake::NOTES)]
    Bake(bake::Arguments),
    /// Finds how far each drive of a file leads the mechanism, and what ends its range.
    ///
    /// Follows the whole curve of configurations, also where the drive cannot lead.
    #[command(after_long_help = range::NOTES)]
    Range(range::Arguments),
}

impl Command {
    /// Does what the command asks for.
    ///
    /// # Errors
    ///
    /// See [`Failure`].
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        match self {
            Self::Motion { file, csv, plots } => {
                let csv = csv.map(target);
                job::motion(&Wanted { file, csv, plots }, interrupted)
            }
            Self::Assemblies(arguments) => arguments.run(interrupted),
            Self::Bake(arguments) => arguments.run(interrupted),
            Self::Range(arguments) => arguments.run(interrupted),
        }
    }
}

/// Does a job of a program; an interrupt sets the flag that it looks at. Says why where it fails.
pub fn exit_code_of(job: impl FnOnce(&AtomicBool) -> Result<(), Failure>) -> ExitCode {
    let interrupted = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&interrupted);
    if let Err(error) = ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed)) {
        eprintln!("note: an interrupt will lose rows: {error}");
    }
    match job(&interrupted) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            if !matches!(failure, Failure::ReaderGone) {
                eprintln!("{failure}");
            }
            ExitCode::from(failure.exit_code())
        }
    }
}

fn target(path: PathBuf) -> Target {
    if path.as_os_str() == "-" {
        Target::Stdout
    } else {
        Target::File(path)
    }
}

const NOTES: &str = "\
Units: lengths in metres, times in seconds, angles in radians; tables and plots are in
millimetres or degrees where they say so.

Points 8 and 11 define the spin axis. The paper prints no coordinates for point 11, the wheel centre:
it is assumed to lie 0.10 m outboard (+y) of point 8, the spin axis parallel to y, where theta = pi/2.
Camber, toe and the height of the wheel centre rest on this assumption; Tables 2 and 3 do not.

Fig. 5 has the paper's kingpin angle, positive where the top leans outboard; kingpin_rad in the CSV file
has the usual sign, positive where it leans inboard.

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, 3 no configuration was found (see
suspension motion --help), 130 interrupted (Ctrl-C, SIGTERM or SIGHUP).";

const MOTION_NOTES: &str = r#"The file:

  linkage = "attia2003"              # or "five_link"
  unit = "m"                         # or "mm": of all lengths here, and of results; no conversion
  [points]                           # chassis points, free points and markers, each by name
  p1 = [-1.396, -0.025, -0.082]
  p11 = { from = "p8", offset = [0.0, 0.1, 0.0] }   # a marker, off another point
  [lengths]                          # optional: all lengths; free points are then but a guess
  d6_1 = 0.445872
  [design]                           # optional: the drives' values at which the mechanism is
  theta = 1.5707963267948966         # assembled and markers are attached; else as the points are
  [time]                             # in seconds; or: instants = [0.0, 0.25, 0.5]
  start = 0.0
  stop = 1.95                        # the last instant is the last multiple of step within stop
  step = 0.05
  [drives]                           # polynomials of time in seconds, constant first,
  theta = [0.7, 0.5, 0.125]          # in rad (angles) or the unit (coordinates)
  height = [0.05, 0.01]              # or, in place of one drive, a measure of the linkage, which
                                     # leads through turning points of the drive: both linkages
                                     # have height, that of the wheel centre, in place of theta

Results, one row an instant: t_s in s; drives in rad or the unit, the one left out too; points _x _y _z in the unit,
_vx per s, _ax per s^2; omega in rad/s, alpha in rad/s^2; kingpin (positive where the top leans inboard), caster (rearwards), camber (outboard)
and toe (front inboard) in rad;
iterations of Newton's method; the largest residual in the unit. Axes: x forward, y left, z up.

In examples/attia2003.toml the wheel centre, point 11, is an assumption: the paper prints no
coordinates for it. It is put 0.10 m outboard (+y) of point 8, on a spin axis parallel to y,
where theta = pi/2.

Exit codes:
  0    done
  1    a result cannot be written
  2    wrong input (file:line:column says where), or --csv names the motion file
  3    no configuration was found: the motion stops short of its last instant (where what leads
       it turns, say), or the points do not assemble in the design position, or the first instant
       is out of reach from there
  130  interrupted (Ctrl-C, SIGTERM or SIGHUP)
Where the motion stops short or is interrupted, the rows up to there are in the CSV file.

Example:
  suspension motion examples/five_link.toml --csv sweep.csv --plots plots"#;
