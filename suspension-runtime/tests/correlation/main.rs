//! Correlation with published results of other programs, one file for each source.
//!
//! The published data are not part of this repository: `SUSPENSION_PUBLISHED_DATA` names the folder that holds
//! them. Tests have the published definitions where those differ from the catalogue's. What is reached, and
//! why where it is not rounding, stands in `docs/correlation.md`.

mod adams;
mod agreement;
mod benchmark_axle;
mod explorer;
mod formula_renault;
mod industrial;
mod lotus;
mod published;
mod rill;
mod simscape;
mod suspension;
