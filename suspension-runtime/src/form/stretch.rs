//! `Stretch`: two points a length apart that is an unknown.

use nalgebra::{SMatrix, Vector3};
use suspension_core::Scalar;
use suspension_core::constraint;
use suspension_core::generated::difference;
use suspension_listing::form;
use suspension_listing::system::System;

use crate::site::{Site, Sites};
use crate::table::Table;
use crate::table::index;

/// A variable length: one row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretch {
    pub(crate) row: u16,
    pub(crate) from: Site,
    pub(crate) to: Site,
    /// The unknown length.
    pub(crate) length: u16,
    /// Where the factors hold the derivatives by `to`, by `from`, and by the length.
    entries: [[u16; 3]; 2],
    by_length: u16,
}

impl Stretch {
    pub(crate) fn new(
        system: &System,
        form: &form::Stretch,
        row: usize,
        entry: impl Fn(usize, Option<usize>) -> u16,
    ) -> Self {
        let [from, to] = [&form.from, &form.to].map(Site::from);
        let length = system.scalar_column(&form.length);
        Self {
            row: index(row),
            from,
            to,
            length: length.map_or(index(usize::MAX), index),
            entries: [to, from].map(|site| [0, 1, 2].map(|axis| entry(row, site.column(axis)))),
            by_length: entry(row, length),
        }
    }

    /// From one point to the other, or its rate.
    #[inline(always)]
    pub(crate) fn vector<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<Vector3<T>> {
        Some(difference(sites.get(self.to)?, sites.get(self.from)?))
    }

    /// The same with the length, or its rate.
    #[inline(always)]
    pub(crate) fn change<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<(Vector3<T>, T)> {
        Some((self.vector(sites)?, sites.scalar(self.length)?))
    }

    /// Writes the derivatives into the factors.
    #[inline(always)]
    pub(crate) fn write<T: Scalar>(
        &self,
        constant: &constraint::Stretch<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        numbers: &mut impl Table<T>,
    ) {
        let Some((vector, length)) = self.change(sites) else {
            return;
        };
        let gradient = constant.gradient(vector);
        for (entries, gradient) in self.entries.iter().zip([gradient, -gradient]) {
            for (entry, value) in entries.iter().zip(gradient.iter()) {
                *numbers.place(*entry) = *value;
            }
        }
        *numbers.place(self.by_length) = constant.by_length(length);
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
        let gradient = constant.gradient(vector);
        let of = |site: Site, gradient: Vector3<T>| {
            [0, 1, 2]
                .map(|axis| site.column(axis))
                .into_iter()
                .zip(gradient.data.0.into_iter().flatten())
        };
        let by_length = (Some(usize::from(self.length)), constant.by_length(length));
        let places = of(self.to, gradient).chain(of(self.from, -gradient));
        for (column, value) in places.chain([by_length]) {
            let place = column.map(|column| (usize::from(self.row), column));
            if let Some(entry) = place.and_then(|place| matrix.get_mut(place)) {
                *entry = value;
            }
        }
    }
}
