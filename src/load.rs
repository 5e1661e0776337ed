//! From a motion file to a mechanism in the configuration of the first instant.

mod across;
mod design;
mod included;
mod led;
mod listing;
mod loaded;
mod notes;
mod off;
mod outlier;
mod points;
mod prepare;
mod start;
mod task;
mod vehicle;

pub(crate) use across::only_across;
pub use loaded::{Loaded, load, load_own};
pub(crate) use points::points;
