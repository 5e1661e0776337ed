//! `Along`: a point on a line, with its distance from the line's start as an unknown.

use nalgebra::{SMatrix, Vector3};
use suspension_core::Scalar;
use suspension_core::constraint::{self, AlongGradient};
use suspension_core::generated::difference;
use suspension_listing::form;
use suspension_listing::system::System;

use crate::plan::{LengthNames, LineLength};
use crate::site::{Site, Sites};
use crate::table::Table;
use crate::table::index;

/// A point on a line: three rows.
#[derive(Clone, Debug)]
pub(crate) struct Along {
    /// The first of its rows.
    pub(crate) row: u16,
    pub(crate) point: Site,
    pub(crate) line: [Site; 2],
    /// The unknown distance.
    pub(crate) distance: u16,
    /// What keeps the line's length.
    pub(crate) length: LineLength,
    /// Where the factors hold the derivatives of each row by the point, by the line's ends, and by the distance.
    entries: [[u16; 4]; 3],
}

impl Along {
    pub(crate) fn new(
        system: &System,
        form: &form::Along,
        row: usize,
        lengths: &LengthNames<'_>,
        entry: impl Fn(usize, Option<usize>) -> u16,
    ) -> Self {
        let distance = system.scalar_column(&form.distance);
        let (point, line) = (
            Site::from(&form.point),
            form.line.each_ref().map(Site::from),
        );
        let [from, to] = line;
        let entries = [0, 1, 2].map(|axis| {
            let sites = [point, from, to].map(|site| entry(row + axis, site.column(axis)));
            let [point, from, to] = sites;
            [point, from, to, entry(row + axis, distance)]
        });
        Self {
            row: index(row),
            point,
            line,
            distance: distance.map_or(index(usize::MAX), index),
            length: lengths.of_line(form.line.each_ref()),
            entries,
        }
    }

    /// The ends of the line.
    #[inline(always)]
    pub(crate) fn ends<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<[Vector3<T>; 2]> {
        let [from, to] = self.line;
        Some([sites.get(from)?, sites.get(to)?])
    }

    /// What is left between the point and the line.
    #[inline(always)]
    pub(crate) fn residual<T: Scalar>(
        &self,
        constant: &constraint::Along<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<Vector3<T>> {
        let point = sites.get(self.point)?;
        Some(constant.residual(point, self.ends(sites)?, sites.scalar(self.distance)?))
    }

    /// From the start of the line to its end, and the distance; or their rates.
    #[inline(always)]
    pub(crate) fn change<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<(Vector3<T>, T)> {
        let [from, to] = self.ends(sites)?;
        Some((difference(to, from), sites.scalar(self.distance)?))
    }

    #[inline(always)]
    pub(crate) fn gradient<T: Scalar>(
        &self,
        constant: &constraint::Along<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<AlongGradient<T>> {
        Some(constant.gradient(self.ends(sites)?, sites.scalar(self.distance)?))
    }

    /// Writes the derivatives into the factors.
    #[inline(always)]
    pub(crate) fn write<T: Scalar>(
        &self,
        constant: &constraint::Along<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        numbers: &mut impl Table<T>,
    ) {
        let Some(gradient) = self.gradient(constant, sites) else {
            return;
        };
        for (entries, by_distance) in self.entries.iter().zip(gradient.distance.iter()) {
            let values = [T::one(), gradient.from, gradient.to, *by_distance];
            for (entry, value) in entries.iter().zip(values) {
                *numbers.place(*entry) = value;
            }
        }
    }

    /// Writes the derivatives into a dense matrix.
    pub(crate) fn write_dense<T: Scalar, const N: usize>(
        &self,
        constant: &constraint::Along<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        matrix: &mut SMatrix<T, N, N>,
    ) {
        let Some(gradient) = self.gradient(constant, sites) else {
            return;
        };
        let [from, to] = self.line;
        let rows = usize::from(self.row)..;
        for (axis, (row, by_distance)) in rows.zip(gradient.distance.iter()).enumerate() {
            let places = [
                (self.point.column(axis), T::one()),
                (from.column(axis), gradient.from),
                (to.column(axis), gradient.to),
                (Some(self.distance.into()), *by_distance),
            ];
            for (column, value) in places {
                let place = column.map(|column| (row, column));
                if let Some(entry) = place.and_then(|place| matrix.get_mut(place)) {
                    *entry = value;
                }
            }
        }
    }
}
