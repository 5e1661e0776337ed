//! The three bounds that the proof needs, with all rounding in them.

use nalgebra::{SMatrix, SVector};
use num_traits::Zero;

use super::enclosed::Enclosed;
use super::inverse::unit;
use crate::arithmetic::magnitude::magnitude;
use crate::arithmetic::scalar::Real;
use crate::error::SolveError;

/// Bounds in the maximum norm. `A` is an approximate inverse of the Jacobian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds<T> {
    /// `|A F(q)|`.
    pub(super) correction: T,
    /// `|I - A J(q)|`.
    pub(super) defect: T,
    /// `|A C(v, w)|` for `|v|, |w| <= 1`.
    pub(super) curvature: T,
}

/// One row of the equations at a position, with bounds of its errors and its curvature.
#[derive(Clone, Copy, Default)]
struct Row<T> {
    /// The residual.
    residual: T,
    /// A bound of the residual's error, including what rounding loses of it in the sum over the rows.
    residual_spread: T,
    /// The same bound for the row of the Jacobian, as a sum of magnitudes.
    jacobian_spread: T,
    /// A bound of the second derivative.
    curvature: T,
}

impl<T: Real> Bounds<T> {
    /// Computes the bounds with an `inverse` of any quality, given column by column. `curvatures` are bounds of
    /// `|C_k(v, w)|` for `|v|, |w| <= 1`.
    ///
    /// A sum of `n` products has an error of at most `n EPSILON` times the sum of the products' magnitudes (Higham
    /// 2002, Accuracy and Stability of Numerical Algorithms, section 3.1, as long as `n EPSILON < 1`).
    ///
    /// # Errors
    ///
    /// [`SolveError::Overflow`] if a bound is not finite.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn new<const N: usize>(
        residual: &SVector<Enclosed<T>, N>,
        jacobian: &SMatrix<Enclosed<T>, N, N>,
        curvatures: &[T; N],
        inverse: &[[T; N]; N],
    ) -> Result<Self, SolveError<T>> {
        let (mut defects, spreads) = defects_and_spreads(inverse, jacobian);
        let rows = rows(residual, &spreads, curvatures);
        let mut sums = [Row::<T>::default(); N];
        for (column, row) in inverse.iter().zip(&rows) {
            for (sum, entry) in sums.iter_mut().zip(column) {
                sum.add(*entry, row);
            }
        }
        for (defect, sum) in defects.iter_mut().zip(&sums) {
            *defect += sum.jacobian_spread;
        }
        Ok(Self {
            correction: upper(sums.map(|sum| sum.residual.abs() + sum.residual_spread))?,
            defect: upper(defects)?,
            curvature: upper(sums.map(|sum| sum.curvature))?,
        })
    }
}

impl<T: Real> Row<T> {
    /// Adds `times` another row; its bounds are multiplied by the magnitude of `times`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn add(&mut self, times: T, row: &Self) {
        let size = times.abs();
        self.residual += times * row.residual;
        self.residual_spread += size * row.residual_spread;
        self.jacobian_spread += size * row.jacobian_spread;
        self.curvature += size * row.curvature;
    }
}

/// The relative rounding error of sums of `N + 1` products and of sums of their magnitudes.
#[cfg_attr(not(debug_assertions), inline(always))]
fn rounding<T: Real, const N: usize>() -> T {
    T::EPSILON * T::constant((2 * N + 16) as f64)
}

/// The equations, row by row.
#[cfg_attr(not(debug_assertions), inline(always))]
fn rows<T: Real, const N: usize>(
    residual: &SVector<Enclosed<T>, N>,
    jacobian_spreads: &[T; N],
    curvatures: &[T; N],
) -> [Row<T>; N] {
    let [residual] = &residual.data.0;
    let mut rows = [Row::default(); N];
    let known = residual.iter().zip(jacobian_spreads).zip(curvatures);
    for (row, ((residual, jacobian_spread), curvature)) in rows.iter_mut().zip(known) {
        let of_sum = residual.value().abs() * rounding::<T, N>() + T::SMALLEST;
        *row = Row {
            residual: residual.value(),
            residual_spread: residual.radius() + of_sum,
            jacobian_spread: *jacobian_spread,
            curvature: *curvature,
        };
    }
    rows
}

/// For each row of `I - A J` the sum of its magnitudes, computed with the midpoints of `J`; and for each row of `J` a
/// bound of the errors of its entries, including what rounding loses of them in these sums.
#[cfg_attr(not(debug_assertions), inline(always))]
fn defects_and_spreads<T: Real, const N: usize>(
    inverse: &[[T; N]; N],
    jacobian: &SMatrix<Enclosed<T>, N, N>,
) -> ([T; N], [T; N]) {
    let mut sums = [rounding::<T, N>(); N];
    let mut spreads = [T::SMALLEST; N];
    for (j, of_jacobian) in jacobian.data.0.iter().enumerate() {
        let [mut column] = unit::<T, N>(j).data.0;
        for ((of_inverse, entry), spread) in inverse.iter().zip(of_jacobian).zip(&mut spreads) {
            // Most entries are zero.
            if !entry.is_zero() {
                *spread += entry.value().abs() * rounding::<T, N>() + entry.radius();
                for (left, right) in column.iter_mut().zip(of_inverse) {
                    *left -= *right * entry.value();
                }
            }
        }
        for (sum, left) in sums.iter_mut().zip(column) {
            *sum += left.abs();
        }
    }
    (sums, spreads)
}

/// An upper bound of all these sums of positive numbers, which rounding may have made smaller.
#[cfg_attr(not(debug_assertions), inline(always))]
fn upper<T: Real, const N: usize>(sums: [T; N]) -> Result<T, SolveError<T>> {
    let largest = magnitude(&SVector::from(sums)).map_err(SolveError::overflow)?;
    Ok(largest * (T::one() + rounding::<T, N>()) + T::SMALLEST)
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector};

    use super::super::verdict::{Certificate, Unproved, judge};
    use super::{Bounds, Enclosed};

    /// The case `F = (0.01, 0)`, `J = I`, `A = share I` and `C` up to 3.
    fn certificate(share: f64) -> Certificate<f64> {
        let residual = SVector::from([0.01, 0.0].map(Enclosed::exact));
        let jacobian = SMatrix::<f64, 2, 2>::identity().map(Enclosed::exact);
        let inverse = [[share, 0.0], [0.0, share]];
        let bounds = Bounds::new(&residual, &jacobian, &[3.0, 2.0], &inverse);
        judge(&bounds.expect("finite"))
    }

    /// The allowance for rounding of two equations, several times over.
    const ROUNDING: f64 = 1e-13;

    #[test]
    fn an_inexact_inverse_widens_the_proved_radius() {
        // The inverse itself: Y = 0.01, Z = 0, K = 3, h = 0.06.
        let Certificate::Proved {
            radius,
            unique_within,
        } = certificate(1.0)
        else {
            panic!("2 K Y < 1")
        };
        assert!((radius - 0.02 / 1.94).abs() < ROUNDING && radius >= 0.02 / 1.94);
        assert!((unique_within - (2.0 / 3.0 - radius)).abs() < ROUNDING);
        // A quarter too small: Y = 0.0075, Z = 0.25, K = 2.25, h = 0.06.
        let Certificate::Proved {
            radius,
            unique_within,
        } = certificate(0.75)
        else {
            panic!("2 K Y < (1 - Z)^2")
        };
        assert!((radius - 0.015 / (0.75 * 1.94)).abs() < ROUNDING);
        assert!((unique_within - (1.5 / 2.25 - radius)).abs() < ROUNDING);
    }

    #[test]
    fn a_matrix_far_from_the_inverse_proves_nothing() {
        for share in [0.0, 2.0, -1.0] {
            let Certificate::Unproved {
                why: Unproved::NearSingular { defect },
            } = certificate(share)
            else {
                panic!("{share} times the identity proves something");
            };
            assert!(defect >= 1.0);
        }
        // Z = 0.97: 2 K Y = 2 * 5.91 * 0.0197 is not below 0.03^2.
        assert!(matches!(
            certificate(1.97),
            Certificate::Unproved {
                why: Unproved::TooFar { .. }
            }
        ));
    }
}
