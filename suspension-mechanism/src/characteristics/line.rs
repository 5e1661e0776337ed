//! One curve over travel or steering.

use crate::characteristics::title::Title;
use crate::mechanism::ends;

/// A quantity along a drive, in units for people.
#[derive(Clone)]
pub struct Line {
    /// Its name, and the wheel to which it belongs.
    pub title: Title,
    /// The name of its quantity in tables, such as `toe`; for a motion ratio that of the measure.
    pub quantity: String,
    /// Its unit.
    pub symbol: String,
    /// Its value at each of the drive's changes; `None` if the mechanism is out of reach, if there is no such number,
    /// or if the line is cut there.
    pub values: Vec<Option<f64>>,
    /// The derivatives of these values with respect to the drive in the file's unit; `None` if there is none.
    pub rates: Vec<Option<f64>>,
    /// Whether it is cut where it is near infinity.
    pub is_cut: bool,
    /// The kind of number.
    pub sort: Sort,
}

impl Line {
    /// Whether its values differ by more than rounding.
    pub fn varies(&self) -> bool {
        /// In units for people, or relative to a larger value.
        const ROUNDING: f64 = 1e-9;
        let ends = ends(self.values.iter().flatten().copied());
        ends.is_some_and(|[low, high]| high - low > ROUNDING * low.abs().max(1.0))
    }
}

/// The kind of number that a line shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sort {
    /// A quantity.
    Quantity,
    /// The value of a measure of the listing.
    Measure,
    /// The derivative of a measure with respect to the drive.
    MotionRatio,
}
