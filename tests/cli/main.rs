//! The program, run like a user runs it. This is a separate test program because it is built in a fraction of the time that
//! the others take.

mod angles;
mod assemblies;
mod axes;
mod axle;
mod bad_input;
mod bake;
mod check;
mod compare;
mod corner;
mod draw;
mod drives_over_time;
mod exact_derivatives;
mod figures;
mod files;
mod first_mistakes;
mod half_turn;
mod help;
mod hostile_files;
mod import;
mod json;
mod led;
mod list;
mod loads;
mod masses;
mod notes;
mod plots;
mod program;
#[cfg(target_os = "linux")]
mod progress;
mod range;
mod reader_gone;
mod results;
mod sensitivities;
mod sheet;
#[cfg(unix)]
mod signals;
mod springs;
mod stops;
#[path = "../support/mod.rs"]
mod support;
mod support_angles;
mod sweep;
mod tables;
mod tolerances;
mod tune;
mod turned;
mod units;
mod vary;
mod virtual_axis;

/// The program that is run.
const PROGRAM: &str = env!("CARGO_BIN_EXE_suspension");
