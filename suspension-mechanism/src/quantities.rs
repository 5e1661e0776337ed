//! The quantities of a mechanism: one catalogue, from which tables, plots, summaries and help are made.

mod axis;
mod beside;
mod brake_and_drive;
mod catalogue;
mod formulas;
mod from_design;
mod in_roll;
mod inert;
mod number;
mod of_axle;
mod on_ground;
mod places;
mod quantity;
mod reader;
mod readings;
mod sprung;
mod steering_wheel;
mod two_drives;
mod wheel;
mod words;

pub use axis::Axis;
pub use catalogue::*;
pub use formulas::Compiled;
pub use number::Number;
pub(crate) use quantity::columns_in;
pub use quantity::{Column, Quantity, Shown, columns};
pub use reader::Reader;
pub use words::{WIDTH, in_words};
