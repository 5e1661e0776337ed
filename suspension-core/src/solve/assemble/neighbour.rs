//! The other root of a pair that a singularity joins.

use nalgebra::SVector;

use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::solve::factored::with_factors;

/// The number of inverse iterations. The weakest direction only starts another search, so two digits are enough.
const ROUNDS: usize = 4;

/// The approximate position of the root that would meet `root` at the nearest singularity.
///
/// Let `v` be the direction in which `J` is weakest, `J v = sigma u` with unit vectors `u` and `v`. Along it the
/// equations are `u . F(root + s v) = sigma s + s^2 u . C(v, v) / 2`, which is zero again at `s = -2 sigma / (u .
/// C(v, v))`.
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
