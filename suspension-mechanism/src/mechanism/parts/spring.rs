//! Springs and anti-roll bars.

use suspension_core::listing::MeasureKind;

/// A spring along a measured length, or a bar about a measured angle.
#[derive(Clone, Debug, PartialEq)]
pub struct Spring {
    /// Its name in the file.
    pub name: String,
    /// The number of its measure.
    pub measure: usize,
    /// The kind of its measure.
    pub kind: MeasureKind,
    /// Its rate: N per unit of length, or N m per radian.
    pub rate: f64,
    /// Its load at the design position, N or N m, positive if it tends to increase the measure.
    pub load: f64,
    /// The measure at the design position, in the file's coordinates.
    pub design: f64,
}

impl Spring {
    /// Its load when its measure is `value`.
    pub(crate) fn load_at(&self, value: f64) -> f64 {
        self.load - self.rate * (value - self.design)
    }
}
