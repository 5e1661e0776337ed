//! A check of whether the fixed order of elimination suits a position.

use nalgebra::{SMatrix, SVector};

use crate::arithmetic::pivot::{growth_limit, is_healthy, least_pivot};
use crate::arithmetic::scalar::Real;
use crate::error::{GeometryError, SolveError};
use crate::linkage::{Factors, Linkage};
use crate::solve::factored::with_factors_for_rates;
use crate::solve::lu::Lu;

/// Refuses a position whose pivots are unhealthy in the fixed order and healthy with partial pivoting. If both are
/// unhealthy the mechanism is near a singularity, which is not a fault of the order.
///
/// # Errors
///
/// [`GeometryError::SmallPivot`].
#[cold]
#[inline(never)]
pub fn check<T, L, const N: usize>(linkage: &L, points: &L::Points) -> Result<(), GeometryError>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
{
    let (q, fixed) = (linkage.unknowns(points), linkage.fixed());
    if is_healthy(linkage.factor(&q, fixed).growth_squared()) {
        return Ok(());
    }
    let jacobian = linkage.jacobian(&q, fixed);
    let mut lu = Lu::unfactored(jacobian);
    let pivoted = lu.eliminate_jacobian(least_pivot());
    if pivoted.is_ok() && is_healthy(lu.growth_squared()) {
        let Elimination { equation, .. } = smallest_in_order(jacobian, linkage.pivots());
        Err(GeometryError::SmallPivot { equation })
    } else {
        Ok(())
    }
}

/// Refuses a position at which a step would be refused, because the Jacobian is too near to a singular one for rates.
///
/// # Errors
///
/// [`GeometryError::Singular`].
#[cold]
#[inline(never)]
pub fn check_regular<T, L, const N: usize>(
    linkage: &L,
    points: &L::Points,
) -> Result<(), GeometryError>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
{
    let q = linkage.unknowns(points);
    match with_factors_for_rates(linkage, &q, linkage.fixed(), |_| ()) {
        Err(SolveError::Singular { part, .. }) => Err(GeometryError::Singular {
            unknown: part.index(),
        }),
        _ => Ok(()),
    }
}

/// The smallest pivot and the growth of the fixed order at a position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elimination<T> {
    /// The equation of the smallest pivot.
    pub equation: usize,
    /// Its unknown.
    pub unknown: usize,
    /// Its size.
    pub pivot: T,
    /// The square root of [`Factors::growth_squared`].
    pub growth: T,
    /// The growth up to which the order is kept; beyond it, partial pivoting takes its place.
    pub allowed: T,
}

impl<T: Real> Elimination<T> {
    /// The smallest pivot and the growth for a linkage at a position.
    pub fn at<L, const N: usize>(linkage: &L, q: &SVector<T, N>, fixed: &L::Fixed) -> Self
    where
        L: Linkage<N, Scalar = T>,
    {
        let growth = linkage.factor(q, fixed).growth_squared().sqrt();
        Self {
            growth,
            ..smallest_in_order(linkage.jacobian(q, fixed), linkage.pivots())
        }
    }
}

/// The smallest pivot of an order; after one that is too small, all are rounding errors.
fn smallest_in_order<T: Real, const N: usize>(
    jacobian: SMatrix<T, N, N>,
    order: &[[usize; 2]],
) -> Elimination<T> {
    let allowed = growth_limit();
    let mut smallest = Elimination {
        equation: 0,
        unknown: 0,
        pivot: T::one() / T::EPSILON,
        growth: T::zero(),
        allowed,
    };
    let mut rows = jacobian.transpose().data.0;
    for &[row, column] in order {
        let Some(pivot_row) = rows.get(row).copied() else {
            continue;
        };
        let pivot = pivot_row.get(column).copied().unwrap_or_default();
        if pivot.abs() < smallest.pivot {
            smallest = Elimination {
                equation: row,
                unknown: column,
                pivot: pivot.abs(),
                ..smallest
            };
        }
        if smallest.pivot * allowed < T::one() {
            break;
        }
        let others = rows.iter_mut().enumerate();
        for (_, other) in others.filter(|(other, _)| *other != row) {
            let multiplier = other.get(column).copied().unwrap_or_default() / pivot;
            for (entry, of_pivot) in other.iter_mut().zip(pivot_row) {
                *entry -= multiplier * of_pivot;
            }
        }
    }
    smallest
}
