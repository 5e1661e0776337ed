//! The tolerance: how small a residual must be.

use crate::arithmetic::scalar::Scalar;

/// The largest residual that counts as a root, a length: each way to step compares with it what is left
/// of the equations, and reports it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance<T> {
    /// A multiple of rounding: of `EPSILON` times the size of the numbers.
    Roundings(T),
    /// In units of length.
    Length(T),
}

impl<T: Scalar> Tolerance<T> {
    /// In units of length, where rounding leaves `rounding` of a length.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn length(self, rounding: T) -> T {
        match self {
            Self::Roundings(multiple) => multiple * rounding,
            Self::Length(length) => length,
        }
    }
}
