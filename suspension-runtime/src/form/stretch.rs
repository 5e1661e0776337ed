//! `Stretch`: two points at a distance that is an unknown.

use nalgebra::Vector3;
use suspension_core::Scalar;
use suspension_core::generated::dot;
use suspension_core::model::constraint;
use suspension_listing::form;

use super::span::Span;
use super::{Entries, Place, Walked};
use crate::site::{Inputs, Sites};
use crate::table::{SPARE, Table, index, put};

/// A variable length: one row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretch {
    pub(crate) span: Span,
    /// The unknown length.
    length: u16,
    /// The place of the derivative with respect to the length.
    by_length: u16,
}

impl Stretch {
    pub(super) fn new(form: &form::Stretch, place: &Place<'_>) -> Self {
        let length = place.system.scalar_column(&form.length);
        Self {
            span: Span::new([&form.from, &form.to], place),
            length: length.map_or(SPARE, index),
            by_length: place.entry(0, length),
        }
    }

    /// The vector between the points and the length, or the rates of both.
    #[inline(always)]
    fn change<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<(Vector3<T>, T)> {
        Some((self.span.vector(sites)?, sites.scalar(self.length)?))
    }
}

impl<T: Scalar, F: Table<Vector3<T>>> Walked<T, F> for Stretch {
    type Constant = constraint::Stretch<T>;

    #[inline(always)]
    fn residual(&self, constant: &Self::Constant, at: &Sites<'_, T, F>, rows: &mut [T]) {
        if let Some((vector, length)) = self.change(at) {
            put(rows, self.span.row, constant.residual(vector, length));
        }
    }

    #[inline(always)]
    fn gradient(&self, constant: &Self::Constant, at: &Sites<'_, T, F>, to: &mut impl Entries<T>) {
        if let Some((vector, length)) = self.change(at) {
            self.span.put(constant.gradient(vector), to);
            to.put(self.by_length, constant.by_length(length));
        }
    }

    #[inline(always)]
    fn curvature(&self, constant: &Self::Constant, [v, w]: [&Sites<'_, T, F>; 2], rows: &mut [T]) {
        if let (Some(v), Some(w)) = (self.change(v), self.change(w)) {
            put(rows, self.span.row, constant.curvature(v, w));
        }
    }

    #[inline(always)]
    fn input_rate(&self, constant: &Self::Constant, inputs: &Inputs<'_, T, F>, rows: &mut [T]) {
        if let Some([vector, rate]) = self.span.moved(inputs) {
            put(rows, self.span.row, dot(constant.gradient(vector), rate));
        }
    }

    fn put_scalars(&self, constant: &Self::Constant, q: &mut [T], fixed: &F) {
        if let Some(vector) = self.span.vector(&Sites::new(q, fixed)) {
            put(q, self.length, constant.reach(vector));
        }
    }
}
