//! `Distance`: two points a constant length apart.

use nalgebra::{SMatrix, Vector3};
use suspension_core::Scalar;
use suspension_core::constraint;
use suspension_listing::form;

use super::span::Span;
use crate::site::Sites;
use crate::table::Table;

/// A constant length: one row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Distance {
    pub(crate) span: Span,
    /// Its place among the lengths.
    pub(crate) length: u16,
}

impl Distance {
    pub(crate) fn new(
        form: &form::Distance,
        row: usize,
        length: u16,
        entry: impl Fn(usize, Option<usize>) -> u16,
    ) -> Self {
        let span = Span::new([&form.from, &form.to], row, entry);
        Self { span, length }
    }

    /// Writes the derivatives into the factors.
    #[inline(always)]
    pub(crate) fn write<T: Scalar>(
        &self,
        constant: &constraint::Distance<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        numbers: &mut impl Table<T>,
    ) {
        if let Some(vector) = self.span.vector(sites) {
            self.span.write(constant.gradient(vector), numbers);
        }
    }

    /// Writes the derivatives into a dense matrix.
    pub(crate) fn write_dense<T: Scalar, const N: usize>(
        &self,
        constant: &constraint::Distance<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        matrix: &mut SMatrix<T, N, N>,
    ) {
        if let Some(vector) = self.span.vector(sites) {
            self.span.write_dense(constant.gradient(vector), matrix);
        }
    }
}
