//! The published mechanism: the paper's tables, and ours beside them.

pub mod comparison;
pub mod figures;
pub mod paper;
