//! Statements of a motion file for single analyses: load cases, sensitivities, tolerances, tuning.

mod changes;
pub(super) mod combined_changes;
mod load_cases;
mod tolerances;
mod tuning;
