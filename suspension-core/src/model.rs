//! What a model of a linkage is made of.

pub mod constraint;
pub mod handedness;
pub mod local;
pub mod measure;
pub mod parts;
pub(crate) mod rows;
