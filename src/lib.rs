//! The program `suspension`: motion files in, tables, CSV files and plots out.
//!
//! All kinematics are those of [`suspension_core`]. From the top: [`cli`] reads options and gives exit codes;
//! each of [`commands`] works on the [`kinematics`] of any linkage, which [`load`] makes of a [`mod@file`];
//! a [`mechanism`] moves, [`quantities`] are read off its states, and [`output`] writes them. Beside them are
//! libraries: [`characteristics`] has values and curves of a design, [`bake`] turns motions into polynomials,
//! [`assemblies`] finds all ways to put a mechanism together, [`reach`] how far a drive leads it, and [`detail`]
//! chooses the cheapest method for a need.

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

pub mod assemblies;
pub mod bake;
pub mod characteristics;
pub mod cli;
pub mod commands;
pub mod detail;
pub mod failure;
pub mod file;
pub mod interrupt;
pub mod kinematics;
pub mod layouts;
pub mod load;
pub mod mechanism;
pub mod number;
pub mod output;
pub mod quantities;
pub mod reach;
