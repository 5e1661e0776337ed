//! `Along`: a point on a line or in a plane, with its distances along the lines as unknowns.

use nalgebra::{SMatrix, SVector, Vector3};
use suspension_core::Scalar;
use suspension_core::constraint::{self, AlongGradient};
use suspension_core::generated::difference;
use suspension_listing::form;
use suspension_listing::system::System;

use super::rates::MovedLines;
use crate::plan::{LengthNames, LineLength};
use crate::site::{Site, Sites};
use crate::table::Table;
use crate::table::index;

/// A point at distances along `K` lines: three rows.
#[derive(Clone, Debug)]
pub(crate) struct Along<const K: usize> {
    /// The first of its rows.
    pub(crate) row: u16,
    pub(crate) point: Site,
    pub(crate) from: Site,
    pub(crate) ends: [Site; K],
    /// The unknown distances.
    pub(crate) distances: [u16; K],
    /// What keeps the first line's length, as far as anything does.
    pub(crate) length: LineLength,
    /// Where the factors hold the derivatives of each row by the point and by the lines' start, and for each line by
    /// its end and by its distance.
    entries: [([u16; 2], [[u16; 2]; K]); 3],
}

impl<const K: usize> Along<K> {
    /// `None` of a form with another number of lines.
    pub(crate) fn new(
        system: &System,
        form: &form::Along,
        row: usize,
        lengths: &LengthNames<'_>,
        entry: impl Fn(usize, Option<usize>) -> u16,
    ) -> Option<Self> {
        let columns = form.distances.iter();
        let columns = columns.map(|distance| system.scalar_column(distance));
        let columns = <[Option<usize>; K]>::try_from(columns.collect::<Vec<_>>()).ok()?;
        let ends: Vec<Site> = form.ends.iter().map(Site::from).collect();
        let ends = <[Site; K]>::try_from(ends).ok()?;
        let (point, from) = (Site::from(&form.point), Site::from(&form.from));
        let entries = [0, 1, 2].map(|axis| {
            let of = |site: Site| entry(row + axis, site.column(axis));
            let mut distances = columns.iter();
            let line = |to: Site| {
                let distance = distances.next().copied().flatten();
                [of(to), entry(row + axis, distance)]
            };
            ([point, from].map(of), ends.map(line))
        });
        Some(Self {
            row: index(row),
            point,
            from,
            ends,
            distances: columns.map(|column| index(column.unwrap_or(usize::MAX))),
            length: lengths.of_line([&form.from, form.ends.first()?]),
            entries,
        })
    }

    /// The lines' other ends, each with its distance; or their rates.
    #[inline(always)]
    fn lines<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<[(Vector3<T>, T); K]> {
        let mut lines = [(Vector3::zeros(), T::zero()); K];
        for (line, (to, distance)) in lines.iter_mut().zip(self.ends.iter().zip(self.distances)) {
            *line = (sites.get(*to)?, sites.scalar(distance)?);
        }
        Some(lines)
    }

    /// Puts the distances among the unknowns.
    #[inline(always)]
    pub(crate) fn put<T: Scalar, const N: usize>(&self, values: [T; K], q: &mut SVector<T, N>) {
        for (distance, value) in self.distances.iter().zip(values) {
            if let Some(place) = q.get_mut(usize::from(*distance)) {
                *place = value;
            }
        }
    }

    /// What is left between the point and the line or plane.
    #[inline(always)]
    pub(crate) fn residual<T: Scalar>(
        &self,
        constant: &constraint::Along<T, K>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<Vector3<T>> {
        let (point, from) = (sites.get(self.point)?, sites.get(self.from)?);
        Some(constant.residual(point, from, self.lines(sites)?))
    }

    /// The same where the points are moved, per unit of that, and the distances rest.
    pub(crate) fn left_where_moved<T: Scalar, F: Table<Vector3<T>>>(
        &self,
        constant: &constraint::Along<T, K>,
        at: &Sites<'_, T, F>,
        moved: &Sites<'_, T, F>,
    ) -> Option<Vector3<T>> {
        let (point, from) = (moved.get(self.point)?, moved.get(self.from)?);
        let mut lines = self.lines(moved)?;
        for (line, (_, distance)) in lines.iter_mut().zip(self.lines(at)?) {
            line.1 = distance;
        }
        Some(constant.residual(point, from, lines))
    }

    /// From the start of each line to its end, and the distance; or their rates.
    #[inline(always)]
    pub(crate) fn change<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<[(Vector3<T>, T); K]> {
        let from = sites.get(self.from)?;
        let lines = self.lines(sites)?;
        Some(lines.map(|(to, distance)| (difference(to, from), distance)))
    }

    #[inline(always)]
    pub(crate) fn gradient<T: Scalar>(
        &self,
        constant: &constraint::Along<T, K>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<AlongGradient<T, K>> {
        Some(constant.gradient(sites.get(self.from)?, self.lines(sites)?))
    }

    /// What the moved points contribute to the rates: `-dF/du udot`.
    #[inline(always)]
    pub(crate) fn input_rate<T: Scalar, F: Table<Vector3<T>>>(
        &self,
        constant: &constraint::Along<T, K>,
        moved: &MovedLines,
        sites: &Sites<'_, T, F>,
        rates: &Sites<'_, T, F>,
    ) -> Option<Vector3<T>> {
        let gradient = self.gradient(constant, sites)?;
        let own = [
            (self.point, T::one(), moved.point),
            (self.from, gradient.from, moved.from),
        ];
        let ends = self.ends.into_iter().zip(gradient.lines).zip(&moved.ends);
        let ends = ends.map(|((to, (by_end, _)), moved)| (to, by_end, *moved));
        let moved = own.into_iter().chain(ends).filter(|(.., moved)| *moved);
        let mut terms = moved.filter_map(|(site, by, _)| Some((rates.get(site)?, by)));
        let (rate, by) = terms.next()?;
        Some(terms.fold(-rate * by, |sum, (rate, by)| sum - rate * by))
    }

    /// Writes the derivatives into the factors.
    #[inline(always)]
    pub(crate) fn write<T: Scalar>(
        &self,
        constant: &constraint::Along<T, K>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        numbers: &mut impl Table<T>,
    ) {
        let Some(gradient) = self.gradient(constant, sites) else {
            return;
        };
        for (axis, ([by_point, by_from], lines)) in self.entries.iter().enumerate() {
            *numbers.place(*by_point) = T::one();
            *numbers.place(*by_from) = gradient.from;
            for ([by_end, by_distance], (end, distance)) in lines.iter().zip(gradient.lines) {
                *numbers.place(*by_end) = end;
                *numbers.place(*by_distance) = along(&distance, axis);
            }
        }
    }

    /// Writes the derivatives into a dense matrix.
    pub(crate) fn write_dense<T: Scalar, const N: usize>(
        &self,
        constant: &constraint::Along<T, K>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        matrix: &mut SMatrix<T, N, N>,
    ) {
        let Some(gradient) = self.gradient(constant, sites) else {
            return;
        };
        for axis in 0..3 {
            let own = [(self.point, T::one()), (self.from, gradient.from)];
            let ends = self.ends.into_iter().zip(gradient.lines);
            let sites = own
                .into_iter()
                .chain(ends.map(|(to, (by_end, _))| (to, by_end)));
            let by_sites = sites.map(|(site, value)| (site.column(axis), value));
            let by_distances = self.distances.iter().zip(gradient.lines);
            let by_distances = by_distances.map(|(distance, (_, by_distance))| {
                let column = usize::from(*distance);
                (Some(column), along(&by_distance, axis))
            });
            for (column, value) in by_sites.chain(by_distances) {
                let place = column.map(|column| (usize::from(self.row) + axis, column));
                if let Some(entry) = place.and_then(|place| matrix.get_mut(place)) {
                    *entry = value;
                }
            }
        }
    }
}

#[inline(always)]
fn along<T: Scalar>(vector: &Vector3<T>, axis: usize) -> T {
    vector.get(axis).copied().unwrap_or_default()
}
