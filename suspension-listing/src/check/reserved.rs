//! Names that the generated code needs.

use crate::name::KEYWORD_OF_2024;

/// The fields of the generated model and its factors, the variables of its methods, and names that a pattern does not
/// bind.
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

/// A name in the form that the generated constants have: two names must differ in this form.
pub(super) fn constant(name: &str) -> String {
    name.to_uppercase()
}
