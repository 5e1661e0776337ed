//! The smallest number of segments with which a tolerance is met.

use std::fmt;

use crate::bake::certify::{Reached, bound, places};
use crate::bake::driven::Derivatives;
use crate::bake::exact::{Exact, OutOfReach};
use crate::bake::scheme::Coefficients;
use crate::number::number;

use crate::bake::baked::{Baked, Wanted};

/// The reason why a motion was not baked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unmet {
    /// The mechanism does not go through the range.
    OutOfReach(OutOfReach),
    /// The tolerance is not met with [`MOST_SEGMENTS`].
    TooManySegments {
        /// The value of the drive near which it was missed.
        at: f64,
    },
}

impl From<OutOfReach> for Unmet {
    fn from(error: OutOfReach) -> Self {
        Self::OutOfReach(error)
    }
}

impl fmt::Display for Unmet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfReach(error) => error.fmt(f),
            Self::TooManySegments { at } => write!(
                f,
                "{MOST_SEGMENTS} segments do not meet the tolerance about {}",
                number(*at)
            ),
        }
    }
}

impl std::error::Error for Unmet {}

/// The largest number of segments of a curve: with more, it no longer fits into the fast caches.
pub const MOST_SEGMENTS: usize = 256;

/// Bakes a motion.
///
/// # Errors
///
/// See [`Unmet`].
pub fn bake(wanted: &Wanted, exact: &dyn Exact) -> Result<Baked, Unmet> {
    let [from, to] = wanted.range;
    let mut missed = 0.5;
    for count in 1..=MOST_SEGMENTS {
        match (Fit {
            wanted,
            exact,
            count,
        })
        .all(missed)?
        {
            Ok(baked) => return Ok(baked),
            Err(at) => missed = at,
        }
    }
    let at = from + (to - from) * missed;
    Err(Unmet::TooManySegments { at })
}

/// An attempt with a number of segments.
pub(super) struct Fit<'a> {
    pub(super) wanted: &'a Wanted,
    pub(super) exact: &'a dyn Exact,
    pub(super) count: usize,
}

/// Whether the tolerance is met, otherwise the place in the range (0 to 1) where it is not.
pub(super) type Met<R = ()> = Result<Result<R, f64>, OutOfReach>;

impl Fit<'_> {
    /// Tries the first segment, the last one, and the one where the tolerance was not met before.
    pub(super) fn outermost(&self, suspect: f64) -> Met {
        for place in [suspect, 0.0, 1.0] {
            if self.segment(self.index(place))?.is_none() {
                return Ok(Err(place));
            }
        }
        Ok(Ok(()))
    }

    /// The number of the segment at a place in the range, 0 to 1.
    fn index(&self, place: f64) -> usize {
        ((place * self.count as f64) as usize).min(self.count - 1)
    }

    /// All segments, otherwise the place in the range (0 to 1) where the tolerance is not met. The segment where it
    /// was not met before is tried first.
    pub(super) fn all(&self, suspect: f64) -> Met<Baked> {
        if self.segment(self.index(suspect))?.is_none() {
            return Ok(Err(suspect));
        }
        let mut segments = Vec::new();
        let mut reached = Reached::default();
        for index in 0..self.count {
            let Some((polynomials, of_segment)) = self.segment(index)? else {
                return Ok(Err((index as f64 + 0.5) / self.count as f64));
            };
            segments.push(polynomials);
            reached = reached.larger(of_segment);
        }
        Ok(Ok(Baked {
            wanted: *self.wanted,
            outputs: self.exact.outputs(),
            reached,
            segments,
        }))
    }

    /// One segment; `None` if it does not meet the tolerance.
    fn segment(&self, index: usize) -> Result<Option<(Vec<Coefficients>, Reached)>, OutOfReach> {
        let Wanted {
            range: [from, to],
            continuity,
            ..
        } = *self.wanted;
        let length = (to - from) / self.count as f64;
        let at = |place: &f64| self.exact.at(from + length * (index as f64 + place));
        let met: Vec<_> = continuity
            .places()
            .iter()
            .map(at)
            .collect::<Result<_, _>>()?;
        let seen: Vec<_> = places().iter().map(at).collect::<Result<_, _>>()?;
        let mut polynomials = Vec::new();
        let mut reached = Reached::default();
        for (number, output) in self.exact.outputs().iter().enumerate() {
            let of_output = |values: &[Vec<Derivatives>]| -> Vec<Derivatives> {
                values.iter().map(|outputs| outputs[number]).collect()
            };
            let polynomial = continuity.fit(length, &of_output(&met));
            let bound = bound(&polynomial, length, &of_output(&seen));
            let scale = output.lever(self.wanted.metre);
            reached = reached.larger(bound.scaled(scale));
            polynomials.push(polynomial);
        }
        Ok((reached.position <= self.wanted.tolerance).then_some((polynomials, reached)))
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::bake::driven::Output;
    use crate::bake::scheme::Continuity;
    use crate::bake::widest::widest;

    /// A point on a circle of radius one.
    struct Circle;

    impl Exact for Circle {
        fn outputs(&self) -> Vec<Output> {
            vec![Output::WheelCentre]
        }

        fn at(&self, at: f64) -> Result<Vec<Derivatives>, OutOfReach> {
            let (y, x) = at.sin_cos();
            Ok(vec![[
                Vector3::new(x, y, 0.0),
                Vector3::new(-y, x, 0.0),
                Vector3::new(-x, -y, 0.0),
            ]])
        }
    }

    /// Every derivative of the circle has length one: over a segment of length `h` the error is
    /// `|product of (x - node)| / 6!` at most, for `h = 1` as given here, and that times `h^6`.
    #[test]
    fn the_number_of_baked_segments_is_minimal() {
        for (continuity, product) in [
            (Continuity::Position, 1.0 / 1024.0),
            (Continuity::Velocity, 1.6546e-3),
            (Continuity::Acceleration, 1.0 / 64.0),
        ] {
            for tolerance in [1e-4_f64, 1e-7, 1e-10] {
                let wanted = Wanted {
                    range: [0.0, 6.0],
                    tolerance,
                    metre: 1.0,
                    continuity,
                };
                let length = (tolerance * 720.0 / product).powf(1.0 / 6.0);
                let expected = 6.0 / length;
                let found = bake(&wanted, &Circle).expect("smooth").segments.len() as f64;
                // The bound takes a few hundredths more than the difference seen.
                let allowed = 0.98 * expected..1.02 * expected + 1.0;
                assert!(
                    allowed.contains(&found),
                    "{continuity:?} {tolerance:e}: {found}, {expected}"
                );
            }
        }
    }

    #[test]
    fn an_unreachable_tolerance_is_refused() {
        let wanted = Wanted {
            range: [0.0, 6.0],
            tolerance: 1e-18,
            metre: 1.0,
            continuity: Continuity::Velocity,
        };
        let refused = bake(&wanted, &Circle);
        assert!(matches!(refused, Err(Unmet::TooManySegments { .. })));
        assert_eq!(widest(&wanted, &Circle), None);
    }
}
