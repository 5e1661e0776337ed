//! A factored Jacobian: in the macro's order of pivots, or where that is unhealthy, with partial
//! pivoting.

use nalgebra::SVector;

use crate::error::SolveError;
use crate::linkage::{Elimination, Linkage};
use crate::lu::Lu;
use crate::scalar::Real;

/// The [growth](Elimination::growth) up to which the fixed order is used: what rounding may cost
/// at most, as a multiple of what it costs with partial pivoting. Over the published motion it is
/// 2 to 300.
const GROWTH_LIMIT: f64 = 1e3;

/// The factors of a Jacobian.
#[derive(Clone, Copy, Debug)]
pub enum Factored<F, T, const N: usize> {
    /// In the macro's order.
    InFixedOrder(F),
    /// With partial pivoting, because `growth > limit` in the macro's order.
    WithPivoting(Lu<T, N>),
}

impl<T: Real, F: Elimination<N, Scalar = T>, const N: usize> Factored<F, T, N> {
    /// Factors the Jacobian of a linkage.
    ///
    /// # Errors
    ///
    /// [`SolveError::Singular`], from partial pivoting.
    #[inline(always)]
    pub fn new<L>(linkage: &L, q: &SVector<T, N>, fixed: &L::Fixed) -> Result<Self, SolveError<T>>
    where
        L: Linkage<N, Scalar = T, Factors = F>,
    {
        // Only its non-zeros are ever computed: the matrix does not outlive this line.
        let factors = F::factor(&linkage.jacobian(q, fixed));
        if factors.growth() <= T::constant(GROWTH_LIMIT) {
            Ok(Self::InFixedOrder(factors))
        } else {
            Self::with_pivoting(linkage, q, fixed)
        }
    }

    #[cold]
    #[inline(never)]
    fn with_pivoting<L>(
        linkage: &L,
        q: &SVector<T, N>,
        fixed: &L::Fixed,
    ) -> Result<Self, SolveError<T>>
    where
        L: Linkage<N, Scalar = T, Factors = F>,
    {
        Lu::factor(&linkage.jacobian(q, fixed)).map(Self::WithPivoting)
    }

    /// The inverse of the smallest pivot, and where partial pivoting met it, its unknown.
    pub fn growth(&self) -> (T, usize) {
        match self {
            Self::InFixedOrder(factors) => (factors.growth(), 0),
            Self::WithPivoting(lu) => {
                let (unknown, pivot) = lu.smallest_pivot();
                (T::one() / pivot, unknown)
            }
        }
    }

    /// Whether the determinant of the Jacobian is positive.
    pub fn has_positive_determinant(&self) -> bool {
        match self {
            Self::InFixedOrder(factors) => factors.determinant_sign() > T::zero(),
            Self::WithPivoting(lu) => lu.has_positive_determinant(),
        }
    }

    /// Solves `J x = right`.
    #[inline(always)]
    pub fn solve(&self, right: &SVector<T, N>) -> SVector<T, N> {
        match self {
            Self::InFixedOrder(factors) => factors.solve(right),
            Self::WithPivoting(lu) => lu.solve(right),
        }
    }
}
