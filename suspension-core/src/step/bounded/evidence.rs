//! The measures by which a step is judged.

use crate::arithmetic::pivot::is_healthy;
use crate::arithmetic::scalar::Real;
use crate::solve::motion::Motion;

/// The evidence by which a [`Step`](super::Step) is judged. It keeps squares of norms, which take no comparison and
/// no root.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Evidence<T> {
    /// The square of the residual that is left, in units of length squared.
    pub residual_squared: T,
    /// The square of the error of the predicted position, in units of length squared.
    pub error_squared: T,
    /// The square of the acceleration. It is not finite if a velocity that an equation with curvature reads is not.
    pub rates_squared: T,
    /// Pivot growth, squared: see [`Factors::growth_squared`](crate::linkage::Factors::growth_squared).
    pub growth_squared: T,
    /// A number with the sign of the Jacobian's determinant.
    pub determinant_sign: T,
    /// See [`count_mirrored`](crate::model::handedness::count_mirrored).
    pub mirrored: T,
}

impl<T> Evidence<T> {
    /// The evidence with each number converted, for example to one of its lanes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn map<U>(self, number: impl Fn(T) -> U) -> Evidence<U> {
        Evidence {
            residual_squared: number(self.residual_squared),
            error_squared: number(self.error_squared),
            rates_squared: number(self.rates_squared),
            growth_squared: number(self.growth_squared),
            determinant_sign: number(self.determinant_sign),
            mirrored: number(self.mirrored),
        }
    }
}

impl<T: Real> Evidence<T> {
    /// Whether the pivots of the macro's order are large enough.
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
