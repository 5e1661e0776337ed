//! The range of an axis, and the numbers on it.

use super::Curve;
use crate::mechanism::ends;
use crate::number::fixed;

/// Returns whether a point can be drawn: it is finite, and so is a range that contains it and others.
pub(super) fn is_finite((across, up): &(f64, f64)) -> bool {
    const GREATEST: f64 = 1e300;
    across.abs() < GREATEST && up.abs() < GREATEST
}

/// The width of a digit in a label, in pixels.
pub(super) const DIGIT: u32 = 8;

/// The range of an axis.
pub(super) struct Axis {
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Axis {
    /// Returns the range of all values, extended by these parts of it below and above.
    pub(super) fn fit(values: impl Iterator<Item = f64>, [below, above]: [f64; 2]) -> Option<Self> {
        /// A smaller range is a constant with rounding errors, which are not drawn as a wave.
        const CONSTANT: f64 = 1e-9;
        /// The range around a constant, relative to its size or to one.
        const AROUND_CONSTANT: f64 = 0.1;
        let [low, high] = ends(values)?;
        let size = high.abs().max(low.abs()).max(1.0);
        let middle = (low + high) / 2.0;
        let span = if high - low > CONSTANT * size {
            high - low
        } else {
            AROUND_CONSTANT * size
        };
        Some(Self {
            low: middle - (0.5 + below) * span,
            high: middle + (0.5 + above) * span,
        })
    }

    /// Returns whether two curves are drawn over each other all along, with the same gaps.
    pub(super) fn shows_as_one(&self, a: &Curve, b: &Curve) -> bool {
        let near = (self.high - self.low) / 400.0;
        let is_one = |(a, b): (&(f64, f64), &(f64, f64))| match [a, b].map(is_finite) {
            [true, true] => a.0 == b.0 && (a.1 - b.1).abs() < near,
            [a, b] => a == b,
        };
        a.line.len() == b.line.len() && a.line.iter().zip(&b.line).all(is_one)
    }

    /// Formats a label, with enough decimals to distinguish about ten of them.
    pub(super) fn label(&self, value: f64) -> String {
        let step = (self.high - self.low) / 10.0;
        let digits = (-step.log10()).ceil().clamp(0.0, 12.0) as usize;
        fixed(value, digits)
    }

    /// Returns the width of the widest label in pixels.
    pub(super) fn label_width(&self) -> u32 {
        let lengths = [self.low, self.high].map(|end| self.label(end).len() as u32);
        lengths[0].max(lengths[1]) * DIGIT
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_with_the_same_gap_are_drawn_over_each_other() {
        let curve = |heights: [f64; 3]| Curve {
            line: [0.0, 1.0, 2.0].into_iter().zip(heights).collect(),
            ..Curve::default()
        };
        let axis = Axis {
            low: 0.0,
            high: 4.0,
        };
        let cut = curve([1.0, 2.0, f64::NAN]);
        assert!(axis.shows_as_one(&cut, &cut.clone()));
        assert!(!axis.shows_as_one(&cut, &curve([1.0, 2.0, 3.0])));
        assert!(!axis.shows_as_one(&cut, &curve([1.0, 3.0, f64::NAN])));
    }
}
