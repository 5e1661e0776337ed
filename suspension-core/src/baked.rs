//! Motions baked into polynomials: look-up instead of solving, if a known tolerance is acceptable.
//!
//! `suspension bake` fits a piecewise polynomial to the motion over the range of one drive, checks it against the
//! solver and writes it as a source file, a module of your program. The file has a [`Curve`], or a [`Surface`] over
//! two drives: a `static` in read-only memory. The outputs for a wheel are its centre and its spin axis, which give
//! [`camber`](crate::wheel::camber) and [`toe`](crate::wheel::toe). Segments have equal length, so finding one takes
//! a multiplication and a truncation, and evaluation takes the same time everywhere.
//!
//! ```
//! use suspension_core::baked::Curve;
//!
//! /// `x^2` and `x^3 / 8`, for x from 0 to 4.
//! static POWERS: Curve<'_, f64, 2, 4> = Curve {
//!     range: [0.0, 4.0],
//!     segments_per_unit: 0.5,
//!     segments: &[
//!         [[0.0, 0.0], [0.0, 0.0], [4.0, 0.0], [0.0, 1.0]],
//!         [[4.0, 1.0], [8.0, 3.0], [4.0, 3.0], [0.0, 1.0]],
//!     ],
//! };
//! let place = POWERS.at(3.0)?;
//! assert_eq!(place.position(), [9.0, 27.0 / 8.0]);
//! let [_, velocity] = place.velocity(10.0); // 10 units of x per second
//! assert_eq!(velocity, [60.0, 270.0 / 8.0]);
//! assert!(POWERS.at(4.5).is_err_and(|outside| outside.nearest == 4.0));
//! # Ok::<(), suspension_core::baked::Outside<f64>>(())
//! ```

mod surface;

use core::fmt;

use crate::arithmetic::scalar::Real;

pub use surface::{Patch, Surface, SurfacePlace};

/// A number that can be split into an index and a remainder.
pub trait Split: Real {
    /// The whole part of a non-negative number, at most `last`, and the remainder.
    fn split(self, last: usize) -> (usize, Self);
}

impl Split for f32 {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn split(self, last: usize) -> (usize, Self) {
        let whole = (self as u32).min(last as u32);
        (whole as usize, self - whole as f32)
    }
}

impl Split for f64 {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn split(self, last: usize) -> (usize, Self) {
        let whole = (self as u32).min(last as u32);
        (whole as usize, self - f64::from(whole))
    }
}

/// A piecewise polynomial of one drive with `OUT` outputs and `TERMS` coefficients per segment, one more than its
/// degree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curve<'a, T, const OUT: usize, const TERMS: usize> {
    /// The drive's first and last value, in metres (or the unit of the hardpoints) or radians.
    pub range: [T; 2],
    /// The number of segments divided by the length of the range.
    pub segments_per_unit: T,
    /// Coefficients indexed by segment, power and output, constants first. Within each segment the variable runs from
    /// 0 to 1.
    pub segments: &'a [[[T; OUT]; TERMS]],
}

/// A value of the drive outside the baked range, or NaN: the motion is not known there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outside<T> {
    /// The drive's value.
    pub drive: T,
    /// The nearest value in the range, for callers that clip; the first value if the drive is NaN.
    pub nearest: T,
}

impl<T: Real> Outside<T> {
    /// `None` if a drive is inside its range.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn check(drive: T, [first, last]: [T; 2]) -> Option<Self> {
        let nearest = if drive > last { last } else { first };
        let inside = first <= drive && drive <= last;
        (!inside).then_some(Self { drive, nearest })
    }
}

impl<T: fmt::Display> fmt::Display for Outside<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { drive, nearest } = self;
        write!(
            f,
            "drive value {drive} is outside the baked range, which ends at {nearest}"
        )
    }
}

impl<T: fmt::Debug + fmt::Display> core::error::Error for Outside<T> {}

/// A place on a [`Curve`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place<'a, T, const OUT: usize, const TERMS: usize> {
    segment: &'a [[T; OUT]; TERMS],
    variable: T,
    segments_per_unit: T,
}

impl<'a, T: Split, const OUT: usize, const TERMS: usize> Curve<'a, T, OUT, TERMS> {
    /// The place where the drive has this value.
    ///
    /// # Errors
    ///
    /// [`Outside`] if the curve does not cover this value. To clip instead: `curve.at(drive).or_else(|outside|
    /// curve.at(outside.nearest))`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn at(&self, drive: T) -> Result<Place<'a, T, OUT, TERMS>, Outside<T>> {
        let [first, _] = self.range;
        let last_segment = self.segments.len().wrapping_sub(1);
        let (index, variable) = ((drive - first) * self.segments_per_unit).split(last_segment);
        match (self.segments.get(index), Outside::check(drive, self.range)) {
            (Some(segment), None) => Ok(Place {
                segment,
                variable,
                segments_per_unit: self.segments_per_unit,
            }),
            // A curve without segments covers no value.
            (_, outside) => Err(outside.unwrap_or(Outside {
                drive,
                nearest: first,
            })),
        }
    }
}

impl<T: Real, const OUT: usize, const TERMS: usize> Place<'_, T, OUT, TERMS> {
    /// The position.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn position(&self) -> [T; OUT] {
        let [position] = polynomial(self.segment, self.variable);
        position
    }

    /// Position and velocity when the drive moves at `rate` per second. With a rate of one, the velocity is the
    /// derivative with respect to the drive.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn velocity(&self, rate: T) -> [[T; OUT]; 2] {
        let [position, first] = polynomial(self.segment, self.variable);
        let rate = rate * self.segments_per_unit;
        [position, first.map(|first| first * rate)]
    }

    /// Position, velocity and acceleration when the drive moves at `rate` per second and `second_rate` per second
    /// squared, by the chain rule `qddot = q'' rate^2 + q' second_rate`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn acceleration(&self, rate: T, second_rate: T) -> [[T; OUT]; 3] {
        let [position, first, half_second] = polynomial(self.segment, self.variable);
        let rate = rate * self.segments_per_unit;
        let second_rate = second_rate * self.segments_per_unit;
        let twice_square = (rate + rate) * rate;
        let mut acceleration = half_second.map(|half| half * twice_square);
        add_product(&mut acceleration, &first, second_rate);
        [position, first.map(|first| first * rate), acceleration]
    }
}

/// A polynomial and its derivatives up to order `ORDERS - 1`, each divided by the factorial of its order, by repeated
/// use of Horner's scheme. Coefficients are ordered by power, constants first.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn polynomial<T: Real, const OUT: usize, const ORDERS: usize>(
    coefficients: &[[T; OUT]],
    variable: T,
) -> [[T; OUT]; ORDERS] {
    let Some((highest, lower)) = coefficients.split_last() else {
        return [[T::zero(); OUT]; ORDERS];
    };
    let mut sums = [*highest; ORDERS];
    for beyond_degree in sums.iter_mut().skip(coefficients.len()) {
        *beyond_degree = [T::zero(); OUT];
    }
    for (power, coefficient) in lower.iter().enumerate().rev() {
        // A derivative of order k has no terms of powers below k.
        let mut carried = *coefficient;
        for sum in sums.iter_mut().take(power + 1) {
            add_product(&mut carried, sum, variable);
            *sum = carried;
        }
    }
    sums
}

/// `sum += factors * scale`, output by output.
#[cfg_attr(not(debug_assertions), inline(always))]
fn add_product<T: Real, const OUT: usize>(sum: &mut [T; OUT], factors: &[T; OUT], scale: T) {
    for (sum, factor) in sum.iter_mut().zip(factors) {
        *sum = *factor * scale + *sum;
    }
}
