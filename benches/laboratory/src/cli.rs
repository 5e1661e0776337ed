//! The command line's options.

mod chart;
mod failures;

use std::sync::atomic::AtomicBool;

use clap::{Parser, Subcommand};
use suspension::failure::Failure;

/// The laboratory: what each method takes and the error it makes, and where each fails.
#[derive(Debug, Parser)]
#[command(name = "suspension-laboratory", version)]
pub struct Options {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Measures every method: what a step takes against the error it makes.
    ///
    /// Writes a table, a figure and a page with all figures; see also benches/rivals.
    #[command(after_long_help = chart::NOTES)]
    Chart(chart::Arguments),
    /// Counts how often each method fails: bad starts, long steps, turning points.
    ///
    /// Writes a table, a figure and a page with all counts.
    #[command(after_long_help = failures::NOTES)]
    Failures(failures::Arguments),
}

impl Command {
    /// Does what the command asks for.
    ///
    /// # Errors
    ///
    /// See [`Failure`].
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        match self {
            Self::Chart(arguments) => arguments.run(interrupted),
            Self::Failures(arguments) => arguments.run(interrupted),
        }
    }
}
