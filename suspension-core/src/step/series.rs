//! The motion near an instant as a polynomial in time, from one factorisation.
//!
//! With `q(t) = sum q_k t^k` and `u(t) = sum u_k t^k` the unknowns and inputs near the instant, the
//! equations, quadratic in both together, hold to order `k` where
//!
//! ```text
//! J q_k = -1/2 sum_{i=1}^{k-1} C((q_i, u_i), (q_{k-i}, u_{k-i})) - dF/du u_k,
//! ```
//!
//! one back-substitution for each order. Orders 1 and 2 are eq. (3) and (7) of Attia 2003.

mod inputs;
mod jet;
mod tracker;

use nalgebra::SVector;

use crate::arithmetic::magnitude::{largest, magnitude};
use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::{Factors, Linkage};
use crate::signal::{ChassisMotion, Signal};
use crate::solve::factored::with_factors_for_rates;
use crate::solve::motion::Motion;

use inputs::PrescribedSeries;
pub use inputs::{ChassisSeries, InputSeries};
pub use jet::{Jet, Quantity};
pub use tracker::SeriesTracker;

/// The motion near an instant, to order `K` in the time from that instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Series<T, const N: usize, const K: usize> {
    /// The Taylor coefficients of the unknowns.
    pub unknowns: Jet<SVector<T, N>, K>,
    /// The sign of the Jacobian's determinant at the instant, and as far as the series is valid: it changes only at a
    /// singularity.
    pub positive_determinant: bool,
    /// Pivot growth: the norm of the pivots' inverses.
    pub growth: T,
}

impl<T: Real, const N: usize, const K: usize> Series<T, N, K> {
    /// The series at a position that solves the linkage for `inputs`.
    ///
    /// # Errors
    ///
    /// [`SolveError::Singular`] as for a [`Tangent`](crate::Tangent), [`SolveError::Overflow`] if a coefficient is
    /// not finite.
    pub fn at<L, C>(
        linkage: &L,
        inputs: &InputSeries<C, L::Drives, K>,
        position: &SVector<T, N>,
    ) -> Result<Self, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisSeries<T, L::Fixed, K>,
    {
        let prescribed = PrescribedSeries::new(linkage, inputs);
        let fixed = &prescribed.fixed.value;
        with_factors_for_rates(linkage, position, fixed, |factors| {
            Self::expand::<L, C>(linkage, &prescribed, *position, factors)
        })?
    }

    /// The same, given the factors.
    pub(crate) fn from_factors<L, C>(
        linkage: &L,
        inputs: &InputSeries<C, L::Drives, K>,
        position: &SVector<T, N>,
        factors: &dyn Factors<T, N>,
    ) -> Result<Self, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisSeries<T, L::Fixed, K>,
    {
        let prescribed = PrescribedSeries::new(linkage, inputs);
        Self::expand::<L, C>(linkage, &prescribed, *position, factors)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn expand<L, C>(
        linkage: &L,
        prescribed: &PrescribedSeries<L::Fixed, L::Drives, K>,
        position: SVector<T, N>,
        factors: &dyn Factors<T, N>,
    ) -> Result<Self, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisSeries<T, L::Fixed, K>,
    {
        let PrescribedSeries { fixed, drives } = prescribed;
        let mut unknowns = Jet::constant(position, SVector::zeros());
        for (index, (u, drive)) in fixed.terms.iter().zip(&drives.terms).enumerate() {
            let mut right = linkage.drive_rate(&position, &fixed.value, u, drive);
            if C::At::MOVES {
                right += linkage.chassis_rate(&position, &fixed.value, u);
            }
            let known = unknowns.terms.get(..index).unwrap_or_default();
            right -= half_curvature(linkage, known, &fixed.terms);
            let term = factors.solve(&right);
            magnitude(&term).map_err(SolveError::overflow)?;
            if let Some(next) = unknowns.terms.get_mut(index) {
                *next = term;
            }
        }
        Ok(Self {
            unknowns,
            positive_determinant: factors.determinant_sign() > T::zero(),
            growth: factors.growth_squared().sqrt(),
        })
    }

    /// An estimate of the radius of convergence, in the unit of time: the distance in the complex plane from the
    /// instant to the nearest singularity of the motion. `None` if it cannot be determined: `K < 3`, or last
    /// coefficients that are zero.
    ///
    /// Where a mechanism turns, its motion is like a square root, whose coefficients make
    ///
    /// ```text
    /// R^2 = |q_{k-2}| / |q_k| (k - 3/2) (k - 5/2) / (k (k - 1)).
    /// ```
    ///
    /// The smaller `R` of `k = K - 1` and `k = K` is returned: a step of two orders bridges the zeros of an even or
    /// odd motion. It is not a bound: a singularity of little weight shows only in high orders. Over the published
    /// motion the estimates from 6 and from 8 orders are within a third of that from 40.
    pub fn radius(&self) -> Option<T> {
        let order = |k: usize| T::constant(k as f64);
        let sizes = self.unknowns.terms.map(|term| {
            let [entries] = term.data.0;
            largest(entries)
        });
        let ratios = (3..=K).rev().take(2).filter_map(|k| {
            let (size, before) = (*sizes.get(k - 1)?, *sizes.get(k - 3)?);
            let known = size > T::zero() && before > T::zero();
            let of_root = (order(k) - T::constant(1.5)) * (order(k) - T::constant(2.5))
                / (order(k) * order(k - 1));
            known.then(|| (before / size * of_root).sqrt())
        });
        ratios.reduce(|a, b| a.min(b))
    }

    /// The motion at the time `dt` from the instant, in either direction.
    pub fn motion(&self, dt: T) -> Motion<T, N> {
        let Signal {
            value,
            rate,
            second_rate,
        } = self.unknowns.at(dt);
        Motion {
            position: value,
            velocity: rate,
            acceleration: second_rate,
            positive_determinant: Some(self.positive_determinant),
        }
    }
}

/// `1/2 sum_{i=1}^{k-1} C((q_i, u_i), (q_{k-i}, u_{k-i}))` from the coefficients of order 1 to `k - 1`. Since `C` is
/// symmetric, each pair is taken once, and half of a coefficient with itself.
pub(crate) fn half_curvature<T, L, const N: usize>(
    linkage: &L,
    known: &[SVector<T, N>],
    fixed: &[L::Fixed],
) -> SVector<T, N>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
{
    let fixed = fixed.get(..known.len()).unwrap_or_default();
    let low = known.iter().zip(fixed);
    let high = known.iter().zip(fixed).rev();
    let half = known.len() / 2;
    let mut sum = SVector::zeros();
    for (index, ((q, u), (p, v))) in low.zip(high).take(known.len() - half).enumerate() {
        let pair = linkage.curvature(q, u, p, v);
        sum += if index == known.len() - 1 - index {
            pair * T::constant(0.5)
        } else {
            pair
        };
    }
    sum
}
