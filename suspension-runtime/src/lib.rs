//! Suspension listings from text, solved without a Rust compiler.
#![forbid(unsafe_code)]

mod build;
mod equations;
pub mod scratch;
mod factors;
mod form;
mod listing;
mod model;
mod plan;
mod site;
mod size;
pub mod table;

pub use listing::Listing;
pub use model::Model;
pub use size::{Room, Size};
