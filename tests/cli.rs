//! The program, run as a user runs it.

mod assemblies;
mod bad_input;
mod bake;
mod figures;
mod files;
mod hostile_files;
mod import;
mod json;
mod led;
mod list;
mod newcomer;
mod notes;
mod plots;
mod program;
mod range;
mod results;
mod sheet;
mod signals;
mod stops;
mod sweep;
mod units;

/// The program that is run.
const PROGRAM: &str = env!("CARGO_BIN_EXE_suspension");
