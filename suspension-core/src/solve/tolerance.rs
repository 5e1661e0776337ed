//! The tolerance: how small a residual must be.

use crate::arithmetic::scalar::Scalar;

/// The largest residual that is accepted as a root, a length. Each way to step compares the remaining residual of the
/// equations with it, and reports it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance<T> {
    /// A multiple of rounding, which is `EPSILON` times the size of the numbers.
    Roundings(T),
    /// In units of length.
    Length(T),
}

impl<T: Scalar> Tolerance<T> {
    /// The tolerance in units of length, if `rounding` is the rounding error of a length.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn length(self, rounding: T) -> T {
        match self {
            Self::Roundings(multiple) => multiple * rounding,
            Self::Length(length) => length,
        }
    }
}
