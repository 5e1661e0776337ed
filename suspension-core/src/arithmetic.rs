//! The numbers that the solver computes with: what it asks of them, and their sine and cosine.

pub(crate) mod entrywise;
pub(crate) mod magnitude;
pub mod scalar;
pub mod trigonometry;
pub(crate) mod vector;
