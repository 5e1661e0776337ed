//! Positions by integrating velocities instead of solving for them.

use nalgebra::SVector;
use suspension_core::{Inputs, Linkage, Real, SolveError, Still, Tangent};

/// One step of the classical fourth-order method of Runge and Kutta for `J qdot = -F_u udot`, from
/// time `from` to time `to`.
///
/// # Errors
///
/// [`SolveError::Singular`] if a velocity is not determined.
pub fn runge_kutta<T, L, const N: usize>(
    linkage: &L,
    inputs: impl Fn(T) -> Inputs<Still, L::Drives>,
    [from, to]: [T; 2],
    q: &SVector<T, N>,
) -> Result<SVector<T, N>, SolveError<T>>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
{
    let two = T::one() + T::one();
    let (step, half) = (to - from, (to - from) / two);
    let [first, middle, last] = [from, from + half, to].map(inputs);
    let velocity = |inputs, q: SVector<T, N>| {
        Tangent::new(linkage, inputs, &q).map(|tangent| tangent.velocity())
    };
    let k1 = velocity(&first, *q)?;
    let k2 = velocity(&middle, q + k1 * half)?;
    let k3 = velocity(&middle, q + k2 * half)?;
    let k4 = velocity(&last, q + k3 * step)?;
    Ok(q + (k1 + (k2 + k3) * two + k4) * (step / (two + two + two)))
}
