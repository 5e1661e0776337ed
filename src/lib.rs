//! The program `suspension`: motion files in, tables, CSV files and plots out.
//!
//! All kinematics are those of [`suspension_core`]; this crate reads a [file](mod@file), brings
//! the mechanism to its first instant ([`setup`]), [sweeps](mod@sweep) through the instants and
//! writes what the core found.

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

pub mod check;
pub mod cli;
pub mod columns;
pub mod comparison;
pub mod csv_file;
pub mod drives;
pub mod failure;
pub mod file;
pub mod instants;
pub mod job;
pub mod output;
pub mod plot;
pub mod polynomial;
pub mod progress;
pub mod published;
pub mod setup;
pub mod source;
pub mod study;
pub mod summary;
pub mod sweep;
