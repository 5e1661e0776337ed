//! The other root of a pair that a singularity joins.

use nalgebra::SVector;

use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::solve::factored::with_factors;

/// Rounds of inverse iteration. The weakest direction only starts another search: two digits do.
const ROUNDS: usize = 4;

/// About where the root lies that would meet `root` at the nearest singularity.
///
/// Along the direction `v` in which `J` is weakest, `J v = sigma u` with unit `u` and `v`, the
/// equations are `u . F(root + s v) = sigma s + s^2 u . C(v, v) / 2`, which is zero again at
/// `s = -2 sigma / (u . C(v, v))`.
///
/// # Errors
///
/// [`SolveError::Singular`] at the singularity itself.
pub(super) fn beyond_singularity<T, L, const N: usize>(
    linkage: &L,
    fixed: &L::Fixed,
    root: &SVector<T, N>,
) -> Result<SVector<T, N>, SolveError<T>>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
{
    with_factors(linkage, root, fixed, T::zero(), |factors| {
        let mut v = SVector::from([T::one(); N]);
        let mut u = v;
        let mut inverse_sigma = T::one();
        for _ in 0..ROUNDS {
            u = factors.solve_transposed(&v);
            u /= u.norm();
            v = factors.solve(&u);
            inverse_sigma = v.norm();
            v /= inverse_sigma;
        }
        let still = L::Fixed::default();
        let bend = u.dot(&linkage.curvature(&v, &still, &v, &still));
        let two = T::constant(2.0);
        root - v * (two / (inverse_sigma * bend))
    })
}
