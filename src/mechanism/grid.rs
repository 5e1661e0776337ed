//! The places of a grid of drives.

use crate::mechanism::description::Description;

/// The most places that a grid may have.
const MOST_PLACES: usize = 1_000_000;

/// Drives and the values that they take, in local coordinates.
#[derive(Clone, Debug, Default)]
pub struct Grid {
    /// Each drive that is swept, by number, with its values; the last changes fastest.
    pub(super) axes: Vec<(usize, Vec<f64>)>,
    /// All drives where the mechanism starts.
    pub(super) start: Vec<f64>,
}

/// So many values, evenly spaced from the first to the last: exact at both ends, and at zero in the middle.
pub fn evenly_spaced([from, to]: [f64; 2], count: usize) -> Vec<f64> {
    let last = count.saturating_sub(1).max(1) as f64;
    let value = |index: usize| {
        let part = index as f64 / last;
        from * (1.0 - part) + to * part
    };
    (0..count).map(value).collect()
}

/// What the values of a grid are counted from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum From {
    /// Where each drive is when the mechanism starts.
    Start,
    /// The drive's own zero.
    Zero,
}

impl Grid {
    /// Drives of a mechanism, by number, each with its values.
    ///
    /// # Errors
    ///
    /// In words, where the places are too many.
    pub fn new(
        mechanism: &Description,
        axes: Vec<(usize, Vec<f64>)>,
        from: From,
    ) -> Result<Self, String> {
        let start = mechanism.first_drives();
        let local = |(drive, values): (usize, Vec<f64>)| {
            let from = match from {
                From::Start => start[drive],
                From::Zero => -mechanism.drive_offsets[drive],
            };
            (
                drive,
                values.into_iter().map(|value| from + value).collect(),
            )
        };
        let axes = axes.into_iter().map(local).collect();
        let grid = Self { axes, start };
        match grid.places() {
            Some(1..=MOST_PLACES) => Ok(grid),
            _ => Err(format!(
                "a grid may have {MOST_PLACES} places at most; take fewer values"
            )),
        }
    }

    /// How many places there are; `None` where they are too many to count.
    pub fn places(&self) -> Option<usize> {
        let mut counts = self.axes.iter().map(|(_, values)| values.len());
        counts.try_fold(1_usize, usize::checked_mul)
    }
}
