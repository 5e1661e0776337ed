//! Springs and anti-roll bars.

use suspension_core::listing::MeasureKind;

/// A spring along a measured length, or a bar about a measured angle.
#[derive(Clone, Debug, PartialEq)]
pub struct Spring {
    /// Its name in the file.
    pub name: String,
    /// The number of its measure.
    pub measure: usize,
    /// What that is.
    pub kind: MeasureKind,
    /// N per unit of length, or N m per radian.
    pub rate: f64,
    /// What it presses at the design position, N or N m, positive where it makes the measure larger.
    pub load: f64,
    /// The measure there, in the file's coordinates.
    pub design: f64,
}

impl Spring {
    /// What it presses where its measure is `value`.
    pub fn presses(&self, value: f64) -> f64 {
        self.load - self.rate * (value - self.design)
    }
}
