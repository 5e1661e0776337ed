//! Listings that are read while a program runs.

mod bound_to_axes;
mod hardpoints;
mod room;
