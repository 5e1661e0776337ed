//! `Product`: two lines at a constant angle.

use nalgebra::Vector3;
use suspension_core::Scalar;
use suspension_core::generated::{difference, dot};
use suspension_core::model::constraint;
use suspension_listing::form;

use super::{Entries, Place, Walked, put_vector};
use crate::plan::lengths::LineLength;
use crate::site::{Inputs, Site, Sites};
use crate::table::{Table, index, put, put_sum};

/// Two lines at an angle: one row.
#[derive(Clone, Debug)]
pub(crate) struct Product {
    pub(crate) row: u16,
    pub(crate) lines: [[Site; 2]; 2],
    /// The parts that keep the length of each line.
    pub(crate) lengths: [LineLength; 2],
    /// The places of the derivatives with respect to the ends of each line.
    entries: [[[u16; 3]; 2]; 2],
}

impl Product {
    pub(super) fn new(form: &form::Product, place: &Place<'_>) -> Self {
        let lines = form.lines.each_ref().map(|line| line.each_ref());
        let sites = lines.map(|line| line.map(Site::from));
        Self {
            row: index(place.row),
            lines: sites,
            lengths: lines.map(|line| place.lengths.line_length(line)),
            entries: sites.map(|line| line.map(|site| place.site_entries(0, site))),
        }
    }

    /// Both lines, or their rates.
    #[inline(always)]
    pub(crate) fn vectors<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<[Vector3<T>; 2]> {
        let [[a, b], [c, d]] = self.lines;
        Some([
            difference(sites.get(b)?, sites.get(a)?),
            difference(sites.get(d)?, sites.get(c)?),
        ])
    }

    /// The derivatives with respect to each of the lines.
    #[inline(always)]
    fn gradients_by_line<T: Scalar>(
        &self,
        constant: &constraint::Product<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<[Vector3<T>; 2]> {
        let [first, second] = self.vectors(sites)?;
        Some([second, first].map(|other| constant.gradient(other)))
    }
}

impl<T: Scalar, F: Table<Vector3<T>>> Walked<T, F> for Product {
    type Constant = constraint::Product<T>;

    #[inline(always)]
    fn residual(&self, constant: &Self::Constant, at: &Sites<'_, T, F>, rows: &mut [T]) {
        if let Some([d, e]) = self.vectors(at) {
            put(rows, self.row, constant.residual(d, e));
        }
    }

    #[inline(always)]
    fn gradient(&self, constant: &Self::Constant, at: &Sites<'_, T, F>, to: &mut impl Entries<T>) {
        let by_lines = self.gradients_by_line(constant, at).into_iter().flatten();
        for ([by_from, by_to], by_line) in self.entries.into_iter().zip(by_lines) {
            put_vector(by_from, -by_line, to);
            put_vector(by_to, by_line, to);
        }
    }

    #[inline(always)]
    fn curvature(&self, constant: &Self::Constant, [v, w]: [&Sites<'_, T, F>; 2], rows: &mut [T]) {
        if let (Some(v), Some(w)) = (self.vectors(v), self.vectors(w)) {
            put(rows, self.row, constant.curvature(v, w));
        }
    }

    #[inline(never)]
    fn input_rate(&self, constant: &Self::Constant, inputs: &Inputs<'_, T, F>, rows: &mut [T]) {
        let by_lines = self
            .gradients_by_line(constant, &inputs.at)
            .into_iter()
            .flatten();
        let terms = self.lines.iter().zip(by_lines).flat_map(|(line, by_line)| {
            let signed = line.iter().zip([T::one(), -T::one()]);
            signed.filter_map(move |(site, sign)| Some(sign * dot(by_line, inputs.rate(*site)?)))
        });
        put_sum(rows, self.row, terms);
    }
}
