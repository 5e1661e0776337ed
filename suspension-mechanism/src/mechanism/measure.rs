//! The measures of a linkage, in which an angle about an axis does not jump at half a turn.

use std::f64::consts::TAU;

use suspension_core::listing::MeasureKind;

/// A measure's value nearest to another value: an angle is given between -pi and pi, and may be off by any number of
/// turns.
pub(crate) fn nearest(kind: MeasureKind, value: f64, to: f64) -> f64 {
    match kind {
        MeasureKind::Angle => value + TAU * ((to - value) / TAU).round_ties_even(),
        MeasureKind::Length => value,
    }
}
