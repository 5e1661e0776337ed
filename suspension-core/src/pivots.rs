//! Whether the fixed order of elimination suits a position.

use nalgebra::SMatrix;

use crate::error::GeometryError;
use crate::factored::{growth_limit, is_healthy, smallest_pivot};
use crate::linkage::{Factors, Linkage};
use crate::lu::Lu;
use crate::scalar::Real;

/// Refuses a position whose pivots are unhealthy in the fixed order and healthy with partial pivoting. Where
/// both are unhealthy the mechanism is near a singularity, which is no fault of the order.
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
    let mut lu = Lu::of(jacobian);
    let pivoted = lu.eliminate_jacobian(smallest_pivot());
    if pivoted.is_ok() && is_healthy(lu.growth_squared()) {
        let equation = smallest_in_order(jacobian, linkage.pivots());
        Err(GeometryError::SmallPivot { equation })
    } else {
        Ok(())
    }
}

/// The equation of the smallest pivot of an order; behind one that is too small all are rounding.
fn smallest_in_order<T: Real, const N: usize>(
    jacobian: SMatrix<T, N, N>,
    order: &[[usize; 2]],
) -> usize {
    let mut rows = jacobian.transpose().data.0;
    let (mut smallest, mut equation) = (T::one() / T::EPSILON, 0);
    for &[row, column] in order {
        let Some(pivot_row) = rows.get(row).copied() else {
            continue;
        };
        let pivot = pivot_row.get(column).copied().unwrap_or_default();
        if pivot.abs() < smallest {
            (smallest, equation) = (pivot.abs(), row);
        }
        if smallest * growth_limit() < T::one() {
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
    equation
}
