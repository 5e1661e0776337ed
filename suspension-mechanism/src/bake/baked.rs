//! A motion as polynomials over segments of a drive's range.

use std::array::from_fn;

use suspension_core::Scalar;
use suspension_core::baked::Curve;

use crate::bake::certify::Reached;
use crate::bake::driven::Output;
use crate::bake::scheme::{Coefficients, Continuity, TERMS};

/// The request for a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted {
    /// The drive's first and last value.
    pub range: [f64; 2],
    /// The largest permitted error of a point, in the unit of the hardpoints.
    pub tolerance: f64,
    /// A metre in that unit: the spin axis may have the same error as a point a metre away.
    pub metre: f64,
    /// The continuity where segments join.
    pub continuity: Continuity,
}

/// A baked motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Baked {
    /// The request.
    pub wanted: Wanted,
    /// The outputs, of three numbers each.
    pub outputs: Vec<Output>,
    /// Bounds of the curve's errors.
    pub reached: Reached,
    /// The polynomials indexed by segment and output.
    pub segments: Vec<Vec<Coefficients>>,
}

impl Baked {
    /// The same curve with positions in coordinates in which the present origin is at `origin`, and with the drive's
    /// `range` in them.
    pub fn moved(mut self, origin: [f64; 3], range: [f64; 2]) -> Self {
        self.wanted.range = range;
        for segment in &mut self.segments {
            for (output, coefficients) in self.outputs.iter().zip(segment) {
                if *output != Output::SpinAxis {
                    let [constant, ..] = coefficients;
                    for (constant, origin) in constant.iter_mut().zip(origin) {
                        *constant += origin;
                    }
                }
            }
        }
        self
    }

    /// The number of segments divided by the length of the range.
    pub fn segments_per_unit(&self) -> f64 {
        let [from, to] = self.wanted.range;
        self.segments.len() as f64 / (to - from)
    }

    /// Numbers indexed by segment, power and output, as in [`Curve`].
    pub fn rows(&self) -> impl Iterator<Item = [Vec<f64>; TERMS]> {
        self.segments.iter().map(|segment| {
            from_fn(|power| segment.iter().flat_map(|output| output[power]).collect())
        })
    }

    /// The segments of a [`Curve`] in a number type; `None` if `OUT` is not the number of outputs. The bounds hold in
    /// `f64`; with `f32`, coordinates lose about a further 1e-7 of their size.
    pub fn table<T: Scalar, const OUT: usize>(&self) -> Option<Vec<[[T; OUT]; TERMS]>> {
        let fixed = |rows: [Vec<f64>; TERMS]| {
            let mut table = [[T::zero(); OUT]; TERMS];
            for (fixed, row) in table.iter_mut().zip(rows) {
                let row: [f64; OUT] = row.try_into().ok()?;
                *fixed = row.map(T::constant);
            }
            Some(table)
        };
        self.rows().map(fixed).collect()
    }

    /// The curve over its [`table`](Self::table).
    pub fn curve<'a, T: Scalar, const OUT: usize>(
        &self,
        table: &'a [[[T; OUT]; TERMS]],
    ) -> Curve<'a, T, OUT, TERMS> {
        Curve {
            range: self.wanted.range.map(T::constant),
            segments_per_unit: T::constant(self.segments_per_unit()),
            segments: table,
        }
    }
}
