//! The command line's options and help.

mod mistyped;
mod signals;

use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;
use std::sync::atomic::AtomicBool;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};

use crate::commands::{
    assemblies, bake, check, compare, draw, import, list, loads, motion, published, range,
    sensitivities, sheet, sweep, tables, tune, vary,
};
use crate::failure::Failure;
use crate::file::tell;
use crate::interrupt;
use mistyped::with_suggestion;
use signals::catch_signals;

/// Suspension kinematics: positions, velocities and accelerations of a driven suspension.
///
/// Without a command, solves the multi-link five-point suspension of Attia 2003 over its
/// published motion, prints the paper's Tables 2 and 3 beside our results, and writes
/// out/attia2003.csv, out/attia2003_height.svg (its Fig. 4) and out/attia2003_angles.svg (Fig. 5).
#[derive(Debug, Parser)]
#[command(name = "suspension", version, verbatim_doc_comment, after_long_help = NOTES)]
pub struct Options {
    /// The command; without one the program solves the published motion.
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Solves the motion that a file describes.
    ///
    /// Prints a summary unless --csv, --json, --parquet or --plots is given.
    Motion(motion::Arguments),
    /// Lists all assemblies of a file's mechanism at values of its drive.
    ///
    /// Also says how sure it is that the list is complete.
    Assemblies(assemblies::Arguments),
    /// Bakes the motion of a file along one drive into a source file.
    ///
    /// The file holds a piecewise polynomial within a tolerance of the solver, looked up in a few nanoseconds:
    /// for scenes of many vehicles, and for controllers.
    Bake(bake::Arguments),
    /// Checks the design position of a file's mechanism.
    ///
    /// Reports freedom, rank, conditioning, how far drives are from locks, and what looks mistaken.
    Check(check::Arguments),
    /// Compares the kinematics of two files' mechanisms, or of one with a table of measured numbers.
    ///
    /// Prints values at the design positions, derivatives, and where curves differ most.
    Compare(compare::Arguments),
    /// Draws the mechanism of a file at its first instant, or at its design position if that is out of reach.
    ///
    /// The SVG shows chassis points, links, slides, bodies, driven and measured lengths, kingpin and wheel, with a legend.
    Draw(draw::Arguments),
    /// Makes a motion file from an engineer's hardpoints.
    ///
    /// Reads tables of points, subsystem files of Adams/Car and model files of Lotus.
    Import(import::Arguments),
    /// Lists the catalogue of layouts, or prints the statements of a layout or of a motion file.
    ///
    /// The list gives each layout's name, description, drives and measures. The statements of a motion file have its points.
    List(list::Arguments),
    /// Prints the forces in a file's mechanism under its load cases.
    ///
    /// Forces on drives, tensions of links, and forces at the joints of bodies and on the chassis; with --drive over a grid.
    Loads(loads::Arguments),
    /// Finds how far each drive of a file leads the mechanism, and what ends its range.
    ///
    /// Follows the whole curve of configurations, even where the drive cannot lead.
    Range(range::Arguments),
    /// Prints how the quantities of a design change when a hardpoint moves.
    ///
    /// Camber, toe, bump steer, motion ratios and all others, per coordinate and per length.
    Sensitivities(sensitivities::Arguments),
    /// Writes the kinematics of a file's mechanism on one page.
    ///
    /// The HTML page has drawings, all quantities with their derivatives, and curves over travel and steering.
    Sheet(sheet::Arguments),
    /// Solves a file's mechanism on a grid of its drives.
    ///
    /// Writes all quantities with their derivatives with respect to each drive.
    Sweep(sweep::Arguments),
    /// Writes the kinematics of a wheel as tables for vehicle models.
    ///
    /// CarSim gets camber, toe and movement of the wheel over jounce; CarMaker gets a linear suspension.
    Tables(tables::Arguments),
    /// Moves hardpoints of a file within boxes until curves are met.
    ///
    /// Curves of bump steer, camber gain, roll centre, motion ratio or any other quantity. Writes a motion file.
    Tune(tune::Arguments),
    /// Varies a hardpoint coordinate or a length, and prints and draws what changes.
    ///
    /// Bump steer, roll centre, motion ratios or any other quantity, a column for each value; curves over travel on a page.
    Vary(vary::Arguments),
}

impl Options {
    /// Parses the command line. Prints the help or the mistake, and exits, if there is one to print.
    pub fn parsed() -> Self {
        let arguments: Vec<OsString> = std::env::args_os().collect();
        let mut program = program(&arguments);
        let matches = program.try_get_matches_from_mut(&arguments);
        matches
            .and_then(|matches| Self::from_arg_matches(&matches))
            .unwrap_or_else(|mistake| exit_with(&with_suggestion(mistake, &program, &arguments)))
    }

    /// Runs the command, or without one solves the published motion.
    ///
    /// # Errors
    ///
    /// See [`Failure`].
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        match self.command {
            None => published::run(interrupted),
            Some(Command::Motion(arguments)) => arguments.run(interrupted),
            Some(Command::Assemblies(arguments)) => arguments.run(interrupted),
            Some(Command::Bake(arguments)) => arguments.run(interrupted),
            Some(Command::Check(arguments)) => arguments.run(interrupted),
            Some(Command::Compare(arguments)) => arguments.run(interrupted),
            Some(Command::Draw(arguments)) => arguments.run(),
            Some(Command::Import(arguments)) => arguments.run(),
            Some(Command::List(arguments)) => arguments.run(),
            Some(Command::Loads(arguments)) => arguments.run(interrupted),
            Some(Command::Range(arguments)) => arguments.run(interrupted),
            Some(Command::Sensitivities(arguments)) => arguments.run(interrupted),
            Some(Command::Sheet(arguments)) => arguments.run(interrupted),
            Some(Command::Sweep(arguments)) => arguments.run(interrupted),
            Some(Command::Tables(arguments)) => arguments.run(interrupted),
            Some(Command::Tune(arguments)) => arguments.run(interrupted),
            Some(Command::Vary(arguments)) => arguments.run(interrupted),
        }
    }
}

/// Returns the commands and their options. The help of `motion` is written only if it is asked for: it names the quantities
/// of a listing, whose equations take longer to order than most commands take.
fn program(arguments: &[OsString]) -> clap::Command {
    let program = Options::command();
    let has = |word: &str| arguments.iter().any(|argument| argument == word);
    if has("motion") && (has("--help") || has("help")) {
        program.mut_subcommand("motion", |motion| motion.after_long_help(motion::help()))
    } else {
        program
    }
}

/// Prints help or a mistake in the options and exits. If the help cannot be written, the exit code is that of a result that
/// cannot be written.
fn exit_with(told: &clap::Error) -> ! {
    let written = told.print().and_then(|()| std::io::stdout().flush());
    let code = match written {
        Err(error) if !told.use_stderr() => {
            exit_code(&Failure::writing("standard output", &error)).into()
        }
        _ => told.exit_code(),
    };
    std::process::exit(code)
}

/// Prints why the program fails and returns its exit code.
fn exit_code(failure: &Failure) -> u8 {
    if !matches!(failure, Failure::ReaderGone) {
        tell(failure);
    }
    failure.exit_code()
}

/// Runs a job, with a flag that an interrupt sets. If the job fails, prints why and returns the exit code.
pub fn run_job(job: impl FnOnce(&AtomicBool) -> Result<(), Failure>) -> ExitCode {
    if let Err(error) = catch_signals() {
        tell(format_args!("note: an interrupt will lose rows: {error}"));
    }
    match job(interrupt::flag()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => ExitCode::from(exit_code(&failure)),
    }
}

const NOTES: &str = "\
Units: lengths are in the unit that the motion file states (m, mm or in; m for the published motion), times in
seconds, angles in radians or, if the file says so, degrees. Tables and plots are in millimetres or degrees where
they say so.

Results without a path of their own go to the folder out, under the name of the motion file: those of files of the same
name in two folders go to the same place, which the options of the commands change.

Points 8 and 11 define the spin axis. The paper prints no coordinates for point 11, the wheel centre. We assume it
0.10 m outboard (+y) of point 8 at theta = pi/2, so that the spin axis is parallel to y there. Camber, toe and
wheel-centre height depend on this assumption; Tables 2 and 3 do not.

Fig. 5 shows the paper's kingpin angle, positive where the top leans outboard. kingpin_rad in the CSV file has the
usual sign, positive where the top leans inboard.

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, 3 the mechanism does not assemble
or locks (see suspension motion --help), 130 interrupted (Ctrl-C, SIGTERM or SIGHUP).";
