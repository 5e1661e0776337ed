//! `Turn`: an angle about an axis, by sine and cosine of its quarter.

use nalgebra::{SMatrix, Vector3};
use suspension_core::Scalar;
use suspension_core::constraint;
use suspension_core::generated::difference;
use suspension_listing::form;
use suspension_listing::system::System;

use crate::site::{Site, Sites};
use crate::table::{SPARE, Table, index};

/// Sine and cosine of a quarter of an angle: one row.
#[derive(Clone, Debug)]
pub(crate) struct Turn {
    pub(crate) row: u16,
    pub(crate) lines: [[Site; 2]; 3],
    /// The unknowns: sine and cosine.
    unknowns: [u16; 2],
    /// Where the factors hold the derivatives by them.
    entries: [u16; 2],
}

impl Turn {
    pub(crate) fn new(
        system: &System,
        form: &form::Turn,
        row: usize,
        entry: impl Fn(usize, Option<usize>) -> u16,
    ) -> Self {
        let columns = [&form.sine, &form.cosine].map(|part| system.scalar_column(part));
        Self {
            row: index(row),
            lines: (form.lines.each_ref()).map(|line| line.each_ref().map(Site::from)),
            unknowns: columns.map(|column| column.map_or(SPARE, index)),
            entries: columns.map(|column| entry(row, column)),
        }
    }

    /// Sine and cosine, or their rates.
    #[inline(always)]
    pub(crate) fn parts<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<[T; 2]> {
        let [sine, cosine] = self.unknowns;
        Some([sites.scalar(sine)?, sites.scalar(cosine)?])
    }

    /// Puts sine and cosine where the sites are `at`.
    pub(crate) fn put<T: Scalar>(
        &self,
        constant: &constraint::Turn<T>,
        at: impl Fn(Site) -> Vector3<T>,
        q: &mut [T],
    ) {
        let lines = self.lines.map(|[from, to]| difference(at(to), at(from)));
        for (unknown, part) in self.unknowns.into_iter().zip(constant.quarter(lines)) {
            if let Some(place) = q.get_mut(usize::from(unknown)) {
                *place = part;
            }
        }
    }

    /// Writes the derivatives into the factors.
    #[inline(always)]
    pub(crate) fn write<T: Scalar>(
        &self,
        constant: &constraint::Turn<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        numbers: &mut impl Table<T>,
    ) {
        let parts = self.parts(sites).into_iter().flatten();
        for (entry, part) in self.entries.into_iter().zip(parts) {
            *numbers.place(entry) = constant.gradient(part);
        }
    }

    /// Writes the derivatives into a dense matrix.
    pub(crate) fn write_dense<T: Scalar, const N: usize>(
        &self,
        constant: &constraint::Turn<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        matrix: &mut SMatrix<T, N, N>,
    ) {
        let parts = self.parts(sites).into_iter().flatten();
        for (unknown, part) in self.unknowns.into_iter().zip(parts) {
            let place = (usize::from(self.row), usize::from(unknown));
            if let Some(entry) = matrix.get_mut(place) {
                *entry = constant.gradient(part);
            }
        }
    }
}
