//! From one configuration to the next: the ways to step.

pub mod bounded;
pub mod series;
pub mod stepper;
pub(crate) mod substeps;
pub mod tracker;
