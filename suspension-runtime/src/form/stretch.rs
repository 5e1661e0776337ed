//! `Stretch`: two points a length apart that is an unknown.

use nalgebra::{SMatrix, Vector3};
use suspension_core::Scalar;
use suspension_core::constraint;
use suspension_listing::form;
use suspension_listing::system::System;

use super::span::Span;
use crate::site::Sites;
use crate::table::{Table, index};

/// A variable length: one row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretch {
    pub(crate) span: Span,
    /// The unknown length.
    pub(crate) length: u16,
    /// Where the factors hold the derivative by the length.
    by_length: u16,
}

impl Stretch {
    pub(crate) fn new(
        system: &System,
        form: &form::Stretch,
        row: usize,
        entry: impl Fn(usize, Option<usize>) -> u16,
    ) -> Self {
        let length = system.scalar_column(&form.length);
        Self {
            by_length: entry(row, length),
            span: Span::new([&form.from, &form.to], row, entry),
            length: length.map_or(index(usize::MAX), index),
        }
    }

    /// The vector between the points with the length, or the rates of both.
    #[inline(always)]
    pub(crate) fn change<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<(Vector3<T>, T)> {
        Some((self.span.vector(sites)?, sites.scalar(self.length)?))
    }

    /// Writes the derivatives into the factors.
    #[inline(always)]
    pub(crate) fn write<T: Scalar>(
        &self,
        constant: &constraint::Stretch<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        numbers: &mut impl Table<T>,
    ) {
        if let Some((vector, length)) = self.change(sites) {
            self.span.write(constant.gradient(vector), numbers);
            *numbers.place(self.by_length) = constant.by_length(length);
        }
    }

    /// Writes the derivatives into a dense matrix.
    pub(crate) fn write_dense<T: Scalar, const N: usize>(
        &self,
        constant: &constraint::Stretch<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        matrix: &mut SMatrix<T, N, N>,
    ) {
        let Some((vector, length)) = self.change(sites) else {
            return;
        };
        self.span.write_dense(constant.gradient(vector), matrix);
        let place = (usize::from(self.span.row), usize::from(self.length));
        if let Some(entry) = matrix.get_mut(place) {
            *entry = constant.by_length(length);
        }
    }
}
