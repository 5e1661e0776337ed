//! Names that the generated code needs.

/// Fields of the generated model and its factors, variables of its methods, and names that a pattern
/// does not bind; and a word that Rust keeps to itself from its edition of 2024 on.
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
    "gen",
];

pub(super) fn is_reserved(name: &str) -> bool {
    RESERVED.contains(&name)
}

/// A name as the generated constants carry it: two names must differ in it.
pub(super) fn constant(name: &str) -> String {
    name.to_uppercase()
}
