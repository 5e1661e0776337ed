//! The laboratory: it plots every method's time against its error ([`chart`]), finds where each method fails
//! ([`failures`]), and has other formulations of the same mechanisms, which the chart compares with the
//! core's.

pub mod chart;
pub mod cli;
pub mod failures;
