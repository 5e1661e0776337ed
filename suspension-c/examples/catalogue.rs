//! All functions for linkages of the catalogue, as a library for C.

pub use suspension_c::*;
