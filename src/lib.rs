//! The program `suspension`: motion files in, tables, CSV files and plots out.
//!
//! All kinematics are those of [`suspension_core`]. This crate reads a motion file and brings the mechanism to its first instant
//! ([`input`]), sweeps through the instants ([`study`]), writes what the core found ([`output`]), and
//! compares it with the paper ([`published`]). It runs steps in [`lanes`], [`bake`]s motions, and
//! chooses the cheapest method for a need ([`detail`]).

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

pub mod assemblies;
pub mod bake;
pub mod cli;
pub mod detail;
pub mod failure;
pub mod input;
pub mod job;
pub mod lanes;
pub mod number;
pub mod output;
pub mod published;
pub mod range;
pub mod study;
