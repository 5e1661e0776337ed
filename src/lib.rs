//! The program `suspension`: it reads motion files and writes tables, CSV files and plots.
//!
//! From the top: [`cli`] reads options and returns exit codes; each of the [`commands`] works on a mechanism that
//! [`suspension_mechanism`] builds from a motion file, and [`output`] writes the results.

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

pub mod cli;
pub mod commands;
pub mod grid;
mod listing_description;
mod option_numbers;
pub mod output;
mod vehicle_corner;

pub use suspension_mechanism::{
    assemblies, bake, characteristics, decimals, failure, file, interrupt, kinematics,
    level_of_detail, loads, measured_table, mechanism, number, prepare, quantities, reach,
    sensitivities, tolerances, tune,
};
