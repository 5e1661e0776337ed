//! The program `suspension`: motion files in, tables, CSV files and plots out.
//!
//! From the top: [`cli`] reads options and gives exit codes; each of [`commands`] works on a mechanism that
//! [`suspension_mechanism`] makes of a motion file, and [`output`] writes what it finds.

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

pub mod cli;
pub mod commands;
pub mod grid;
pub mod layouts;
mod mistyped;
mod option;
pub mod output;

pub use suspension_mechanism::{
    assemblies, bake, characteristics, detail, failure, file, interrupt, kinematics, load, loads,
    mechanism, number, quantities, reach, sensitivities, tolerances, tune,
};
