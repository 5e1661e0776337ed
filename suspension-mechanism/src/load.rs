//! From a motion file to a mechanism in the configuration of the first instant.

mod assembled;
mod cases;
mod columns;
mod coupling;
mod design;
mod flat_body;
mod included;
mod led;
mod listing;
mod loaded;
mod masses;
mod missing_travel;
mod notes;
mod outlier;
mod own_motion;
mod points;
mod prepare;
mod request;
mod said_of_drives;
mod said_of_wheels;
mod springs;
mod start;
mod stated;
mod steering_wheel;
mod task;
mod tolerances;
mod tuning;
mod turned;
mod unsatisfied;
mod unstated;
mod usual_drives;
mod vehicle;
mod wrong_side;

pub use loaded::{Loaded, load, load_own};
pub use points::points;
pub use wrong_side::only_on_wrong_side;
