//! From a motion file to a mechanism in the configuration of the first instant.

mod design;
mod included;
mod led;
mod listing;
mod loaded;
mod notes;
mod off;
mod points;
mod prepare;
mod start;
mod task;
mod vehicle;

pub use loaded::{Loaded, load, load_own};
pub(crate) use points::points;
