//! Numbers such as `1,250`, which are one or one thousand.

use std::ops::Range;

use super::row::Row;
use crate::failure::Failure;
use crate::file::Source;

/// What the numbers of a table tell about its commas and points.
#[derive(Debug, Default)]
pub(super) struct Thousands {
    /// The first number such as `1,250`, with its place.
    unclear: Option<(Range<usize>, String)>,
    /// Whether a number such as `12,5` shows decimals.
    has_decimals: bool,
    /// Whether a number such as `250` has none.
    has_whole: bool,
}

impl Thousands {
    /// Adds the numbers of a row.
    pub(super) fn add(&mut self, row: &Row<'_>) {
        for number in row.written_numbers() {
            let digits = number.trim_start_matches(|c: char| !c.is_ascii_digit());
            match digits.split_once([',', '.']) {
                None => self.has_whole |= digits.len() > 1,
                Some((first, behind)) if is_group(first, behind) => {
                    let unclear = || (row.place.clone(), number.to_owned());
                    self.unclear.get_or_insert_with(unclear);
                }
                // `1,640.5` says what its comma is.
                Some((_, behind)) if behind.contains([',', '.']) => {}
                Some(_) => self.has_decimals = true,
            }
        }
    }

    /// Checks that the numbers show whether `1,250` is one or one thousand.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if there is such a number beside whole ones, and no number has other decimals.
    pub(super) fn check(self, source: &Source) -> Result<(), Failure> {
        match self.unclear {
            Some((place, number)) if self.has_whole && !self.has_decimals => {
                let digits = number.replace([',', '.'], "");
                let message = format!(
                    "`{number}` may be {digits}, or a number with decimals: write {digits}, or {number}0 for decimals"
                );
                Err(source.refuse(&place, &message))
            }
            _ => Ok(()),
        }
    }
}

/// Returns whether digits around a comma or point may be a thousand and the three digits below it.
fn is_group(first: &str, behind: &str) -> bool {
    let is_one = first.len() == 1 && first != "0";
    is_one && behind.len() == 3 && behind.chars().all(|c| c.is_ascii_digit())
}
