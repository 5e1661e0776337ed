//! From a motion file to a mechanism in the configuration of the first instant.

mod assembled;
mod beside;
mod cases;
mod columns;
mod coupling;
mod design;
mod flat_body;
mod flat_listing;
mod included;
mod led;
mod listing;
mod loaded;
mod masses;
mod notes;
mod outlier;
mod own_linkage;
mod own_motion;
mod points;
mod prepare;
mod springs;
mod start;
mod stated;
mod steering_wheel;
mod task;
mod together;
mod tolerances;
mod tuning;
mod turned;
mod unsatisfied;
mod usual_drives;
mod vehicle;

pub use loaded::{Loaded, load};
pub use notes::wrong_side::only_on_wrong_side;
pub use own_linkage::load_own;
pub use points::points;
pub use together::describe_one_sided;
