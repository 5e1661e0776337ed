//! The numbers that the solver computes with: what it asks of them, their sine and cosine, and how small a pivot may be beside
//! rounding.

pub(crate) mod entrywise;
pub(crate) mod magnitude;
pub(crate) mod pivot;
pub mod scalar;
pub mod trigonometry;
pub(crate) mod vector;
