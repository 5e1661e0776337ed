//! Words for units of length.

use super::spelling::is_one_of;
use crate::mechanism::Length;

/// Units of length that motion files do not have.
const OTHER_UNITS: &str = "cm centimeter centimetre centimeters centimetres dm km ft foot feet";

/// Returns whether a word names a unit of length.
pub(super) fn is_unit(word: &str) -> bool {
    unit(word).is_some() || is_one_of(word, OTHER_UNITS)
}

/// Returns the unit of length that a word names.
///
/// # Errors
///
/// A sentence, if motion files do not have the unit.
pub(super) fn length(word: &str) -> Result<Length, String> {
    unit(word).ok_or_else(|| {
        format!("lengths are in `{word}`; convert them to mm, m or in, and say so here")
    })
}

/// Returns the unit of motion files that a word names.
pub(super) fn unit(word: &str) -> Option<Length> {
    match word {
        "mm" | "millimeter" | "millimetre" | "millimeters" | "millimetres" => {
            Some(Length::Millimetre)
        }
        "m" | "meter" | "metre" | "meters" | "metres" => Some(Length::Metre),
        "in" | "inch" | "inches" | "zoll" => Some(Length::Inch),
        _ => None,
    }
}
