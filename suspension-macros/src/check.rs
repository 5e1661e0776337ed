//! Whether a listing makes sense: names first, then uses, counts and structural rank.

mod determined;
mod names;
mod uses;

pub(crate) use determined::determined;
pub(crate) use names::names;
pub(crate) use uses::{angles, chassis_points};

/// Fields of the generated model and variables of its methods that are not the user's.
const RESERVED: [&str; 6] = [
    "fixed",
    "size",
    "drive_rate",
    "fixed_rate",
    "v_fixed",
    "w_fixed",
];
