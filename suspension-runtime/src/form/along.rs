//! `Along`: a point on a line or in a plane, with its distances along the lines as unknowns.

use nalgebra::Vector3;
use suspension_core::Scalar;
use suspension_core::generated::difference;
use suspension_core::model::constraint::{self, AlongGradient, InPlane, OnLine};
use suspension_listing::form;

use super::{Entries, Place, Walked};
use crate::plan::lengths::LineLength;
use crate::site::{Inputs, Site, Sites};
use crate::table::{SPARE, Table, index, put, put_three};

/// A point at distances along `K` lines: three rows.
#[derive(Clone, Debug)]
pub(crate) struct Along<const K: usize> {
    /// The first of its rows.
    pub(crate) row: u16,
    pub(crate) point: Site,
    pub(crate) from: Site,
    pub(crate) ends: [Site; K],
    /// The unknown distances.
    distances: [u16; K],
    /// The part that keeps the first line's length, if any does.
    pub(crate) length: LineLength,
    /// The places of each row's derivatives: with respect to the point and to the lines' start, and for each line to
    /// its end and to its distance.
    entries: [([u16; 2], [[u16; 2]; K]); 3],
}

impl<const K: usize> Along<K> {
    /// `None` for a form with another number of lines.
    pub(super) fn new(form: &form::Along, place: &Place<'_>) -> Option<Self> {
        let columns = form.distances.iter();
        let columns = columns.map(|distance| place.system.scalar_column(distance));
        let columns = <[Option<usize>; K]>::try_from(columns.collect::<Vec<_>>()).ok()?;
        let ends: Vec<Site> = form.ends.iter().map(Site::from).collect();
        let ends = <[Site; K]>::try_from(ends).ok()?;
        let (point, from) = (Site::from(&form.point), Site::from(&form.from));
        let entries = [0, 1, 2].map(|axis| {
            let of = |site: Site| place.entry(axis, site.column(axis));
            let mut lines = [[SPARE; 2]; K];
            for (line, (end, distance)) in lines.iter_mut().zip(ends.iter().zip(columns)) {
                *line = [of(*end), place.entry(axis, distance)];
            }
            ([point, from].map(of), lines)
        });
        Some(Self {
            row: index(place.row),
            point,
            from,
            ends,
            distances: columns.map(|column| column.map_or(SPARE, index)),
            length: place.lengths.line_length([&form.from, form.ends.first()?]),
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

    /// The residual per unit of the displacement when the points are moved and the distances are not.
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

    /// The vector from the start of each line to its end, and the distance; or their rates.
    #[inline(always)]
    fn change<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<[(Vector3<T>, T); K]> {
        let from = sites.get(self.from)?;
        let lines = self.lines(sites)?;
        Some(lines.map(|(to, distance)| (difference(to, from), distance)))
    }

    #[inline(always)]
    fn derivatives<T: Scalar>(
        &self,
        constant: &constraint::Along<T, K>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<AlongGradient<T, K>> {
        Some(constant.gradient(sites.get(self.from)?, self.lines(sites)?))
    }
}

/// A line, or the lines of a plane: the distances at which it is nearest to a point.
pub(crate) trait Nearest<T, const K: usize> {
    fn nearest(&self, point: Vector3<T>, from: Vector3<T>, ends: [Vector3<T>; K]) -> [T; K];
}

impl<T: Scalar> Nearest<T, 1> for OnLine<T> {
    fn nearest(&self, point: Vector3<T>, from: Vector3<T>, ends: [Vector3<T>; 1]) -> [T; 1] {
        self.distances(point, from, ends)
    }
}

impl<T: Scalar> Nearest<T, 2> for InPlane<T> {
    fn nearest(&self, point: Vector3<T>, from: Vector3<T>, ends: [Vector3<T>; 2]) -> [T; 2] {
        self.distances(point, from, ends)
    }
}

impl<T: Scalar, F: Table<Vector3<T>>, const K: usize> Walked<T, F> for Along<K>
where
    constraint::Along<T, K>: Nearest<T, K>,
{
    type Constant = constraint::Along<T, K>;

    #[inline(always)]
    fn residual(&self, constant: &Self::Constant, at: &Sites<'_, T, F>, rows: &mut [T]) {
        let places = at.get(self.point).zip(at.get(self.from));
        if let (Some((point, from)), Some(lines)) = (places, self.lines(at)) {
            put_three(rows, self.row, constant.residual(point, from, lines));
        }
    }

    #[inline(always)]
    fn gradient(&self, constant: &Self::Constant, at: &Sites<'_, T, F>, to: &mut impl Entries<T>) {
        let Some(gradient) = self.derivatives(constant, at) else {
            return;
        };
        for (axis, ([by_point, by_from], lines)) in self.entries.iter().enumerate() {
            to.put(*by_point, T::one());
            to.put(*by_from, gradient.from);
            for ([by_end, by_distance], (end, distance)) in lines.iter().zip(gradient.lines) {
                to.put(*by_end, end);
                to.put(
                    *by_distance,
                    distance.get(axis).copied().unwrap_or_default(),
                );
            }
        }
    }

    #[inline(always)]
    fn curvature(&self, constant: &Self::Constant, [v, w]: [&Sites<'_, T, F>; 2], rows: &mut [T]) {
        if let (Some(v), Some(w)) = (self.change(v), self.change(w)) {
            put_three(rows, self.row, constant.curvature(v, w));
        }
    }

    #[inline(never)]
    fn input_rate(&self, constant: &Self::Constant, inputs: &Inputs<'_, T, F>, rows: &mut [T]) {
        let Some(gradient) = self.derivatives(constant, &inputs.at) else {
            return;
        };
        let own = [(self.point, T::one()), (self.from, gradient.from)];
        let ends = self.ends.into_iter().zip(gradient.lines);
        let by_sites = own
            .into_iter()
            .chain(ends.map(|(to, (by_end, _))| (to, by_end)));
        let mut terms = by_sites.filter_map(|(site, by)| Some((inputs.rate(site)?, by)));
        if let Some((rate, by)) = terms.next() {
            let sum = terms.fold(-rate * by, |sum, (rate, by)| sum - rate * by);
            put_three(rows, self.row, sum);
        }
    }

    fn put_scalars(&self, constant: &Self::Constant, q: &mut [T], fixed: &F) {
        let sites = Sites::new(q, fixed);
        let at = |site| sites.get(site).unwrap_or_default();
        let distances = constant.nearest(at(self.point), at(self.from), self.ends.map(at));
        for (unknown, distance) in self.distances.into_iter().zip(distances) {
            put(q, unknown, distance);
        }
    }
}
