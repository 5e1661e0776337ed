//! The results of a motion over time: tables, plots and a summary.

pub mod plots;
pub mod record;
pub mod summary;
