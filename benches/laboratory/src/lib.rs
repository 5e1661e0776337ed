//! The laboratory: every method's time against its error ([`chart`]), where each method fails
//! ([`failures`]), and other formulations of the same mechanisms, which the chart sets beside the
//! core's.

pub mod chart;
pub mod cli;
pub mod failures;
