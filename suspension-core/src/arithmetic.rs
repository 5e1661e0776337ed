//! The numbers that the solver computes with: the operations that it needs, sine and cosine, and how small a pivot may be.

pub(crate) mod entrywise;
pub(crate) mod magnitude;
pub(crate) mod pivot;
pub mod scalar;
pub mod trigonometry;
pub(crate) mod vector;
