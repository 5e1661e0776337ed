//! The published mechanism: the paper's tables, and ours beside them.

pub mod comparison;
pub mod paper;
