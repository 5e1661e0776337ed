//! From a motion file to a mechanism in the configuration of the first instant.
//!
//! `loaded` reads the file and its `listing`; `mechanism` goes through the steps: `assembled` at the `design` position, with
//! the data of the `vehicle`, then moved to the `first_instant`. `notes` are on what the author may not have meant;
//! `analyses` reads what only some commands need.

mod analyses;
mod assembled;
mod column_names;
mod design;
mod first_instant;
mod listing;
mod loaded;
mod measured_points;
mod mechanism;
mod notes;
mod other_axes;
mod own_linkage;
mod own_motion;
mod stated_laws;
mod task;
mod vehicle;

pub use analyses::combined_changes::describe_one_sided;
pub use listing::points::point_names;
pub use loaded::{Loaded, load};
pub use own_linkage::load_own;
