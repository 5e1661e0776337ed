//! The approximate inverse of a Jacobian.

use nalgebra::{SMatrix, SVector};
use num_traits::{One, Zero};

use super::enclosed::Enclosed;
use crate::arithmetic::scalar::Real;
use crate::linkage::Factors;

/// How each column of an inverse `A` is found: by a back-substitution, or from another column.
///
/// Suppose that an unknown `u` has the coefficient 1 in an equation `k` and occurs in only one other equation `l`, as
/// the coordinates of a carried point with one link do. Then `J e_u = e_k + J_lu e_l`, and so `A e_k = e_u - J_lu A
/// e_l`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Columns<const N: usize>([Option<Derived>; N]);

/// The column of equation `k`, derived from another one.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Derived {
    /// `u`.
    unknown: usize,
    /// `l`.
    from: usize,
}

impl<const N: usize> Columns<N> {
    /// Chosen by the entries that are exactly zero or one in all enclosed Jacobians.
    pub(super) fn new<T: Real>(jacobians: &SMatrix<Enclosed<T>, N, N>) -> Self {
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

    /// Derives a column from another one, unless it is derived already, other columns are derived from it, or the
    /// other one is itself derived. The column from which another is derived is thus always found by a
    /// back-substitution.
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

    /// Finds the columns of `A` with factors of any quality.
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

/// The unit vector of an equation, or of an unknown.
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
    use nalgebra::{Matrix3, Matrix4};

    use super::{Columns, Derived, Enclosed};
    use crate::solve::lu::Lu;

    /// Any number.
    fn any() -> Enclosed<f64> {
        Enclosed::within(0.0, 1.0)
    }

    /// Unknown by unknown: in three equations; of a carried point with one link, which is the equation before the one with the
    /// coefficient 1; the same, behind it; without a coefficient 1.
    fn jacobians() -> Matrix4<Enclosed<f64>> {
        let [zero, one] = [0.0, 1.0].map(Enclosed::exact);
        Matrix4::from([
            [one, zero, any(), any()],
            [any(), zero, one, zero],
            [zero, one, zero, any()],
            [any(), zero, zero, any()],
        ])
    }

    #[test]
    fn inverse_columns_of_carried_coordinates_are_derived_from_others() {
        let derived = |unknown, from| Some(Derived { unknown, from });
        let Columns(columns) = Columns::new(&jacobians());
        assert_eq!(columns, [None, derived(2, 3), derived(1, 0), None]);
    }

    #[test]
    fn no_inverse_column_is_derived_from_a_derived_column() {
        let [zero, one] = [0.0, 1.0].map(Enclosed::exact);
        let ring = Matrix3::from([[one, any(), zero], [zero, one, any()], [any(), zero, one]]);
        let Columns(columns) = Columns::new(&ring);
        for derived in columns.iter().flatten() {
            assert_eq!(columns[derived.from], None, "{columns:?}");
        }
        assert!(columns.iter().any(Option::is_some));
    }

    #[test]
    fn derived_columns_complete_the_inverse() {
        let jacobian = Matrix4::from([
            [1.0, 0.0, 0.2, 0.9],
            [0.3, 0.0, 1.0, 0.0],
            [0.0, 1.0, 0.0, 1.1],
            [-0.7, 0.0, 0.0, 0.4],
        ]);
        let mut factors = Lu::unfactored(jacobian);
        factors.eliminate_jacobian(0.0).expect("regular");
        let mut inverse = [[f64::NAN; 4]; 4];
        let columns = Columns::new(&jacobians());
        columns.invert(&factors, &jacobian.map(Enclosed::exact), &mut inverse);
        let defect = Matrix4::from(inverse) * jacobian - Matrix4::identity();
        assert!(defect.amax() < 1e-15, "{defect}");
    }
}
