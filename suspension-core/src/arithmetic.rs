//! The numbers that the solver computes with, and what it computes of them: functions, vectors, bounds.

pub(crate) mod entrywise;
pub(crate) mod magnitude;
pub mod scalar;
pub mod trigonometry;
pub(crate) mod vector;
