//! Errors, as `Copy` values.
//!
//! They hold indices of equations, unknowns, points and lengths. With a listing or a model of it
//! ([`SolveError::named`]) they print names. [`Cause`] has a row for each kind of failure.

use core::fmt;

use crate::arithmetic::scalar::Real;

mod cause;
mod geometry;
mod message;
mod solve;

pub use cause::Cause;
pub use geometry::GeometryError;
pub(crate) use message::messages;
pub use message::{Compared, Explain, Facts, Failure};
pub use solve::SolveError;

messages! {
    [T: Real] SolveError<T>;
    [] GeometryError;
}

/// A formula of Attia (2003) is 0/0 here: `|denominator| <= threshold`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Indeterminate<T> {
    /// The denominator `w . n`, where `w` is the angular velocity (eq. 9) or acceleration (eq. 10) and `n` the normal
    /// of the three points.
    pub denominator: T,
    /// The threshold that its magnitude must exceed.
    pub threshold: T,
}

impl<T: fmt::LowerExp> fmt::Display for Indeterminate<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "0/0: the vector that is asked for lies in the plane of the points (denominator {:.1e}, threshold {:.1e})",
            self.denominator, self.threshold
        )
    }
}

impl<T: fmt::Debug + fmt::LowerExp> core::error::Error for Indeterminate<T> {}
