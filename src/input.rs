//! From a motion file to a mechanism in the configuration of its first instant.

pub mod check;
pub mod drives;
pub mod file;
pub mod instants;
pub mod leading;
pub mod polynomial;
pub mod setup;
pub mod source;
