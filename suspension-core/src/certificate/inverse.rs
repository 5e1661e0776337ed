//! The approximate inverse of a Jacobian.

use nalgebra::{SMatrix, SVector};
use num_traits::{One, Zero};

use super::enclosed::Enclosed;
use crate::arithmetic::scalar::Real;
use crate::linkage::Factors;

/// How each column of an inverse `A` is found: by a back-substitution, or from another column.
///
/// Where an unknown `u` has the coefficient 1 in an equation `k` and is in one other equation `l` alone,
/// as the coordinates of a carried point with one link are, `J e_u = e_k + J_lu e_l`, so that
/// `A e_k = e_u - J_lu A e_l`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Columns<const N: usize>([Option<Derived>; N]);

/// The column of equation `k`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Derived {
    /// `u`.
    unknown: usize,
    /// `l`.
    from: usize,
}

impl<const N: usize> Columns<N> {
    /// By the entries that are zero, or one, in all of the Jacobians that are enclosed.
    pub(super) fn of<T: Real>(jacobians: &SMatrix<Enclosed<T>, N, N>) -> Self {
        let mut columns = Self([None; N]);
        for (unknown, column) in jacobians.data.0.iter().enumerate() {
            let mut entries = column.iter().enumerate().filter(|(_, x)| !x.is_zero());
            let pair = [entries.next(), entries.next(), entries.next()];
            if let [Some(first), Some(second), None] = pair {
                for ((equation, entry), (from, _)) in [(first, second), (second, first)] {
                    if entry.is_one() {
                        columns.derive(equation, Derived { unknown, from });
                    }
                }
            }
        }
        columns
    }

    /// Derives a column, unless one of the two is derived already or has others derived from it.
    fn derive(&mut self, equation: usize, derived: Derived) {
        let is_from_it = self.0.iter().flatten().any(|other| other.from == equation);
        let is_from_derived = matches!(self.0.get(derived.from), Some(Some(_)));
        if let Some(column @ None) = self.0.get_mut(equation)
            && !is_from_it
            && !is_from_derived
        {
            *column = Some(derived);
        }
    }

    /// Finds the columns of `A` by factors of any quality.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn invert<T: Real>(
        &self,
        factors: &impl Factors<T, N>,
        jacobian: &SMatrix<Enclosed<T>, N, N>,
        inverse: &mut [[T; N]; N],
    ) {
        for (equation, (column, derived)) in inverse.iter_mut().zip(&self.0).enumerate() {
            if derived.is_none() {
                [*column] = factors.solve(&unit(equation)).data.0;
            }
        }
        for (equation, derived) in self.0.iter().enumerate() {
            if let Some(Derived { unknown, from }) = *derived
                && let Some(other) = inverse.get(from).copied()
                && let Some(coefficient) = jacobian.get((from, unknown))
                && let Some(column) = inverse.get_mut(equation)
            {
                [*column] = unit(unknown).data.0;
                for (entry, other) in column.iter_mut().zip(other) {
                    *entry -= coefficient.value() * other;
                }
            }
        }
    }
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn unit<T: Real, const N: usize>(k: usize) -> SVector<T, N> {
    let mut unit = [T::zero(); N];
    if let Some(entry) = unit.get_mut(k) {
        *entry = T::one();
    }
    SVector::from(unit)
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3, SMatrix};

    use super::{Columns, Derived, Enclosed};
    use crate::solve::lu::Lu;

    /// Any number.
    fn any() -> Enclosed<f64> {
        Enclosed::within(0.0, 1.0)
    }

    /// The first two unknowns are of two carried points with the link of the third row.
    fn jacobians() -> Matrix3<Enclosed<f64>> {
        let [zero, one] = [0.0, 1.0].map(Enclosed::exact);
        Matrix3::new(
            one,
            zero,
            any(), //
            zero,
            one,
            any(), //
            any(),
            any(),
            any(),
        )
    }

    #[test]
    fn the_columns_of_carried_coordinates_are_derived() {
        let from = 2;
        let derived = |unknown| Some(Derived { unknown, from });
        assert_eq!(Columns::of(&jacobians()).0, [derived(0), derived(1), None]);
    }

    #[test]
    fn nothing_is_derived_from_what_is_derived() {
        let [zero, one] = [0.0, 1.0].map(Enclosed::exact);
        let ring = SMatrix::from([[one, any(), zero], [zero, one, any()], [any(), zero, one]]);
        let Columns(columns) = Columns::of(&ring);
        for derived in columns.iter().flatten() {
            assert_eq!(columns[derived.from], None, "{columns:?}");
        }
        assert!(columns.iter().any(Option::is_some));
    }

    #[test]
    fn what_is_derived_is_the_inverse() {
        let jacobian = Matrix3::new(1.0, 0.0, 0.3, 0.0, 1.0, -0.7, 0.2, 0.9, 1.1);
        let mut factors = Lu::of(jacobian);
        factors.eliminate_jacobian(0.0).expect("regular");
        let mut inverse = [[f64::NAN; 3]; 3];
        let columns = Columns::of(&jacobians());
        columns.invert(&factors, &jacobian.map(Enclosed::exact), &mut inverse);
        let defect = Matrix3::from(inverse) * jacobian - Matrix3::identity();
        assert!(defect.amax() < 1e-15, "{defect}");
    }
}
