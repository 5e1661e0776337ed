//! `Turn`: an angle about an axis, by sine and cosine of its quarter.

use nalgebra::Vector3;
use suspension_core::Scalar;
use suspension_core::generated::difference;
use suspension_core::model::constraint;
use suspension_listing::form;

use super::{Entries, Place, Walked};
use crate::site::{Site, Sites};
use crate::table::{SPARE, Table, index, put};

/// Sine and cosine of a quarter of an angle: one row.
#[derive(Clone, Debug)]
pub(crate) struct Turn {
    row: u16,
    pub(crate) lines: [[Site; 2]; 3],
    /// The unknowns: sine and cosine.
    unknowns: [u16; 2],
    /// The places of the derivatives with respect to them.
    entries: [u16; 2],
}

impl Turn {
    pub(super) fn new(form: &form::Turn, place: &Place<'_>) -> Self {
        let columns = [&form.sine, &form.cosine].map(|part| place.system.scalar_column(part));
        Self {
            row: index(place.row),
            lines: (form.lines.each_ref()).map(|line| line.each_ref().map(Site::from)),
            unknowns: columns.map(|column| column.map_or(SPARE, index)),
            entries: columns.map(|column| place.entry(0, column)),
        }
    }

    /// Sine and cosine, or their rates.
    #[inline(always)]
    fn parts<T: Scalar>(&self, sites: &Sites<'_, T, impl Table<Vector3<T>>>) -> Option<[T; 2]> {
        let [sine, cosine] = self.unknowns;
        Some([sites.scalar(sine)?, sites.scalar(cosine)?])
    }
}

impl<T: Scalar, F: Table<Vector3<T>>> Walked<T, F> for Turn {
    type Constant = constraint::Turn<T>;

    #[inline(always)]
    fn residual(&self, constant: &Self::Constant, at: &Sites<'_, T, F>, rows: &mut [T]) {
        if let Some([sine, cosine]) = self.parts(at) {
            put(rows, self.row, constant.residual(sine, cosine));
        }
    }

    #[inline(always)]
    fn gradient(&self, constant: &Self::Constant, at: &Sites<'_, T, F>, to: &mut impl Entries<T>) {
        let parts = self.parts(at).into_iter().flatten();
        for (entry, part) in self.entries.into_iter().zip(parts) {
            to.put(entry, constant.gradient(part));
        }
    }

    #[inline(always)]
    fn curvature(&self, constant: &Self::Constant, [v, w]: [&Sites<'_, T, F>; 2], rows: &mut [T]) {
        if let (Some(v), Some(w)) = (self.parts(v), self.parts(w)) {
            put(rows, self.row, constant.curvature(v, w));
        }
    }

    fn put_scalars(&self, constant: &Self::Constant, q: &mut [T], fixed: &F) {
        let sites = Sites::new(q, fixed);
        let at = |site| sites.get(site).unwrap_or_default();
        let lines = self.lines.map(|[from, to]| difference(at(to), at(from)));
        for (unknown, part) in self.unknowns.into_iter().zip(constant.quarter(lines)) {
            put(q, unknown, part);
        }
    }
}
