//! Single precision beside `f64`: how far off it is, and what it refuses.

mod case;
mod chassis_axes;
mod published;
mod random;
