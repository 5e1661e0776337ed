//! Names that the generated code needs.

use crate::name::KEYWORD_OF_2024;

/// Fields of the generated model and its factors, variables of its methods, and names that a pattern
/// does not bind.
const RESERVED: [&str; 14] = [
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
    "Listing",
    KEYWORD_OF_2024,
];

pub(super) fn is_reserved(name: &str) -> bool {
    RESERVED.contains(&name)
}

/// A name as the generated constants carry it: two names must differ in it.
pub(super) fn constant(name: &str) -> String {
    name.to_uppercase()
}
