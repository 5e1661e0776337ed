//! The equations and their derivatives, walked.

use nalgebra::{ArrayStorage, SMatrix, SVector};
use suspension_core::Scalar;

use crate::form::{Entries, Walked, walk};
use crate::model::Model;
use crate::plan::place_in_matrix;
use crate::site::{Inputs, Sites};
use crate::size::{Chassis, Few, Room, Size};
use crate::table::Table;

impl<T: Scalar, const N: usize> Model<'_, T, N>
where
    Room<N>: Size,
{
    /// Writes in place, like all functions here for vectors of unknowns: what a call returns is copied.
    #[inline(never)]
    pub(crate) fn residual_to(
        &self,
        rows: &mut [T; N],
        q: &SVector<T, N>,
        fixed: &Chassis<T, N>,
        drives: &Few<T, N>,
    ) {
        let at = Sites::new(q.as_slice(), fixed).with(drives.as_slice());
        // Rows beyond those of the listing hold their unknown at zero.
        *rows = q.data.0[0];
        walk!(self.forms(), all(), self, |form, constant| {
            form.residual(constant, &at, rows)
        });
    }

    #[inline(always)]
    pub(crate) fn jacobian(&self, q: &SVector<T, N>, fixed: &Chassis<T, N>) -> SMatrix<T, N, N> {
        let at = Sites::new(q.as_slice(), fixed);
        let mut matrix = SMatrix::from_array_storage(ArrayStorage([[T::zero(); N]; N]));
        let mut entries = Whole(&mut matrix);
        walk!(
            &self.plan().forms_in_matrix,
            all(),
            self,
            |form, constant| { form.gradient(constant, &at, &mut entries) }
        );
        for beyond in usize::from(self.plan().unknowns)..N {
            if let Some(entry) = matrix.get_mut((beyond, beyond)) {
                *entry = T::one();
            }
        }
        matrix
    }

    /// Writes into rows that are [`zeros`].
    #[inline(never)]
    pub(crate) fn curvature_to(
        &self,
        rows: &mut [T; N],
        v: &SVector<T, N>,
        v_fixed: &Chassis<T, N>,
        w: &SVector<T, N>,
        w_fixed: &Chassis<T, N>,
    ) {
        let (v, w) = (
            Sites::new(v.as_slice(), v_fixed),
            Sites::new(w.as_slice(), w_fixed),
        );
        walk!(self.forms(), all(), self, |form, constant| {
            form.curvature(constant, [&v, &w], rows)
        });
    }

    /// Writes `-dF/du udot`, the right-hand side of the rates, into rows that are [`zeros`]: for the drives and the
    /// chassis points that they move, or without `drive_rate` for all other chassis points.
    #[inline(never)]
    pub(crate) fn input_rates_to(
        &self,
        rows: &mut [T; N],
        q: &SVector<T, N>,
        fixed: &Chassis<T, N>,
        fixed_rate: &Chassis<T, N>,
        drive_rate: Option<&Few<T, N>>,
    ) {
        let inputs = Inputs {
            at: Sites::new(q.as_slice(), fixed),
            chassis_rate: fixed_rate,
            drive_rate: drive_rate.map_or(&[], Table::as_slice),
            driven: &self.plan().driven,
            are_driven: drive_rate.is_some(),
        };
        walk!(
            &self.plan().forms,
            entered(inputs.are_driven),
            self,
            |form, constant| { form.input_rate(constant, &inputs, rows) }
        );
    }
}

/// A whole matrix.
struct Whole<'a, T, const N: usize>(&'a mut SMatrix<T, N, N>);

impl<T: Scalar, const N: usize> Entries<T> for Whole<'_, T, N> {
    fn put(&mut self, entry: u16, derivative: T) {
        if let Some(place) = self.0.get_mut(place_in_matrix(entry)) {
            *place = derivative;
        }
    }
}

/// Rows without contributions: zeros that leave no trace in a sum, not even in its sign.
#[inline(always)]
pub(crate) fn zeros<T: Scalar, const N: usize>() -> SVector<T, N> {
    SVector::from_array_storage(ArrayStorage([[-T::zero(); N]]))
}

/// The entries of a vector of unknowns or rows.
#[inline(always)]
pub(crate) fn rows<T, const N: usize>(vector: &mut SVector<T, N>) -> &mut [T; N] {
    let [rows] = &mut vector.data.0;
    rows
}
