//! Whether a listing makes sense: names first, then uses, counts and structural rank.

mod determined;
mod names;
mod uses;

pub use determined::determined;
pub use names::names;
pub use uses::{angles, chassis_points};

/// Fields of the generated model and its factors, variables of its methods, and names that a pattern
/// does not bind.
const RESERVED: [&str; 12] = [
    "fixed",
    "size",
    "drive_rate",
    "fixed_rate",
    "v_fixed",
    "w_fixed",
    "growth_squared",
    "determinant_sign",
    "None",
    "Some",
    "Ok",
    "Err",
];

fn is_reserved(name: &str) -> bool {
    RESERVED.contains(&name)
}

/// A name as the generated constants carry it: two names must differ in it.
fn constant(name: &str) -> String {
    name.to_uppercase()
}
