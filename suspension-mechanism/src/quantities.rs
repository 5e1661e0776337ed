//! The quantities of a mechanism: one catalogue, from which tables, plots, summaries and help are made.
//!
//! A row of the `catalogue` has a formula made of `readings`; these take what they need of a state from its `reader`, which
//! computes what several of them share once.

mod axis;
mod catalogue;
mod formulas;
mod help;
mod number;
mod quantity;
mod reader;
mod readings;

pub use axis::Axis;
pub use catalogue::*;
pub use formulas::Compiled;
pub use help::{WIDTH, in_words};
pub use number::Number;
pub(crate) use quantity::columns_in;
pub use quantity::{Column, Quantity, Shown, columns};
pub use reader::Reader;
