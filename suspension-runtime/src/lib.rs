//! Suspension listings from text, solved without a Rust compiler.
#![forbid(unsafe_code)]
// Nothing on the solving path may panic.
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing
    )
)]

mod build;
mod equations;
mod factors;
mod fitted;
mod form;
mod lengths;
mod linkage;
mod listing;
mod model;
mod names;
mod plan;
mod rates;
mod readout;
mod site;
mod size;
mod table;

pub use factors::Factors;
pub use fitted::{Fitted, Work};
pub use listing::{Listing, ModelError};
pub use model::Model;
pub use size::{Room, Size};
pub use suspension_listing::text::{Mistake, Mistakes};
pub use table::{Masked, Table, Value};
