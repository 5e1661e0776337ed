//! What a step is judged by.

use crate::arithmetic::pivot::is_healthy;
use crate::arithmetic::scalar::Real;
use crate::solve::motion::Motion;

/// What a [`Step`](super::Step) is judged by; what a listing measures is in [`Linkage::Measures`](crate::Linkage::Measures). Squares of norms: to form them takes no comparison and no root.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measures<T> {
    /// The residual that is left, square of a length.
    pub residual_squared: T,
    /// The error of the predicted position, square of a length.
    pub error_squared: T,
    /// The acceleration: not finite where a rate is not that an equation with curvature reads.
    pub rates_squared: T,
    /// The health of the pivots: see [`Factors::growth_squared`](crate::linkage::Factors).
    pub growth_squared: T,
    /// A number with the sign of the Jacobian's determinant.
    pub determinant_sign: T,
    /// See [`count_mirrored`](crate::model::handedness::count_mirrored).
    pub mirrored: T,
}

impl<T> Measures<T> {
    /// Each measure of another number: a lane of it, say.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn map<U>(self, number: impl Fn(T) -> U) -> Measures<U> {
        Measures {
            residual_squared: number(self.residual_squared),
            error_squared: number(self.error_squared),
            rates_squared: number(self.rates_squared),
            growth_squared: number(self.growth_squared),
            determinant_sign: number(self.determinant_sign),
            mirrored: number(self.mirrored),
        }
    }
}

impl<T: Real> Measures<T> {
    /// Whether the pivots of the macro's order will do.
    #[inline]
    pub fn is_healthy(&self) -> bool {
        is_healthy(self.growth_squared)
    }

    /// The motion with the sign of the determinant.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn signed<const N: usize>(&self, motion: Motion<T, N>) -> Motion<T, N> {
        Motion {
            positive_determinant: Some(self.determinant_sign > T::zero()),
            ..motion
        }
    }
}
