//! The smallest number of segments with which a tolerance is met.

use crate::bake::certify::{Reached, bound, places};
use crate::bake::path::{Derivatives, OutOfReach, Output};
use crate::bake::scheme::Continuity;

/// What to bake.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted {
    /// The drive's first and last value.
    pub range: [f64; 2],
    /// How far a point may be off, in the unit of the hardpoints.
    pub tolerance: f64,
    /// A metre in that unit: the spin axis may be off by as much as a point a metre away.
    pub metre: f64,
    /// How segments join.
    pub continuity: Continuity,
}

/// A baked motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Baked {
    /// What was asked for.
    pub wanted: Wanted,
    /// The outputs, three numbers each.
    pub outputs: Vec<Output>,
    /// Bounds of what the curve is off by.
    pub reached: Reached,
    /// Coefficients by segment, output and power.
    pub segments: Vec<Vec<Vec<[f64; 3]>>>,
}

/// Why a motion was not baked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unmet {
    /// The mechanism does not go through the range.
    OutOfReach(OutOfReach),
    /// The tolerance is not met with [`MOST_SEGMENTS`]; the drive's value where it is missed most.
    TooManySegments {
        /// The drive's value there.
        at: f64,
    },
}

impl From<OutOfReach> for Unmet {
    fn from(error: OutOfReach) -> Self {
        Self::OutOfReach(error)
    }
}

/// Segments that a curve may have: with more, a look-up leaves the fast caches.
pub const MOST_SEGMENTS: usize = 512;

/// The exact outputs at a value of the drive.
pub type Exact<'a> = dyn Fn(f64) -> Result<Vec<Derivatives>, OutOfReach> + 'a;

/// Bakes a motion.
///
/// # Errors
///
/// See [`Unmet`].
pub fn bake(wanted: &Wanted, outputs: &[Output], exact: &Exact<'_>) -> Result<Baked, Unmet> {
    let mut worst = 0.5;
    for count in 1..=MOST_SEGMENTS {
        let fit = Fit {
            wanted,
            outputs,
            exact,
            count,
        };
        match fit.all(worst)? {
            Ok(baked) => return Ok(baked),
            Err(at) => worst = at,
        }
    }
    let [from, to] = wanted.range;
    Err(Unmet::TooManySegments {
        at: from + (to - from) * worst,
    })
}

/// A try with a number of segments.
struct Fit<'a> {
    wanted: &'a Wanted,
    outputs: &'a [Output],
    exact: &'a Exact<'a>,
    count: usize,
}

type Segment = (Vec<Vec<[f64; 3]>>, Reached);

impl Fit<'_> {
    /// All segments, or where in the range (0 to 1) the tolerance is not met: tried first where it
    /// was not met before.
    fn all(&self, suspect: f64) -> Result<Result<Baked, f64>, OutOfReach> {
        let first = ((suspect * self.count as f64) as usize).min(self.count - 1);
        if self.segment(first)?.is_none() {
            return Ok(Err(suspect));
        }
        let mut segments = Vec::new();
        let mut reached = Reached::default();
        for index in 0..self.count {
            let Some((coefficients, of_segment)) = self.segment(index)? else {
                return Ok(Err((index as f64 + 0.5) / self.count as f64));
            };
            segments.push(coefficients);
            reached = reached.larger(of_segment);
        }
        Ok(Ok(Baked {
            wanted: *self.wanted,
            outputs: self.outputs.to_vec(),
            reached,
            segments,
        }))
    }

    /// One segment; `None` where it does not meet the tolerance.
    fn segment(&self, index: usize) -> Result<Option<Segment>, OutOfReach> {
        let Wanted {
            range: [from, to],
            continuity,
            ..
        } = *self.wanted;
        let length = (to - from) / self.count as f64;
        let at = |place: &f64| {
            (self.exact)(from + (to - from) * (index as f64 + place) / self.count as f64)
        };
        let met = continuity
            .places()
            .iter()
            .map(at)
            .collect::<Result<Vec<_>, _>>()?;
        let seen = places().iter().map(at).collect::<Result<Vec<_>, _>>()?;
        let mut segment = Vec::new();
        let mut reached = Reached::default();
        for (number, output) in self.outputs.iter().enumerate() {
            let of_output = |values: &[Vec<Derivatives>]| -> Vec<Derivatives> {
                values.iter().map(|outputs| outputs[number]).collect()
            };
            let coefficients = continuity.fit(length, &of_output(&met));
            let bound = bound(&coefficients, length, &of_output(&seen));
            let scale = match output {
                Output::SpinAxis => self.wanted.metre,
                Output::Point(_) | Output::WheelCentre => 1.0,
            };
            reached = reached.larger(bound.scaled(scale));
            segment.push(coefficients);
        }
        Ok((reached.position <= self.wanted.tolerance).then_some((segment, reached)))
    }
}
