//! The front end of a listing: from its text to a system of equations and the order in which they are
//! eliminated.
//!
//! `suspension-macros` writes Rust of it; at run time the same system is walked.

pub mod ast;
pub mod check;
mod cluster;
pub mod eliminate;
pub mod errors;
pub mod lower;
pub mod parse;
pub mod sample;
pub mod system;
#[cfg(test)]
mod tests;
