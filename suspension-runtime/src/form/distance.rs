//! `Distance`: two points a constant length apart.

use nalgebra::Vector3;
use suspension_core::Scalar;
use suspension_core::generated::dot;
use suspension_core::model::constraint;
use suspension_listing::form;

use super::span::Span;
use super::{Entries, Place, Walked};
use crate::site::{Inputs, Sites};
use crate::table::{Table, put};

/// A constant length: one row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Distance {
    pub(crate) span: Span,
    /// Its index among the lengths.
    pub(crate) length: u16,
}

impl Distance {
    pub(super) fn new(form: &form::Distance, place: &Place<'_>) -> Self {
        Self {
            span: Span::new([&form.from, &form.to], place),
            length: place.lengths.place(place.name),
        }
    }
}

impl<T: Scalar, F: Table<Vector3<T>>> Walked<T, F> for Distance {
    type Constant = constraint::Distance<T>;

    #[inline(always)]
    fn residual(&self, constant: &Self::Constant, at: &Sites<'_, T, F>, rows: &mut [T]) {
        if let Some(vector) = self.span.vector(at) {
            put(rows, self.span.row, constant.residual(vector));
        }
    }

    #[inline(always)]
    fn gradient(&self, constant: &Self::Constant, at: &Sites<'_, T, F>, to: &mut impl Entries<T>) {
        if let Some(vector) = self.span.vector(at) {
            self.span.put(constant.gradient(vector), to);
        }
    }

    #[inline(always)]
    fn curvature(&self, constant: &Self::Constant, [v, w]: [&Sites<'_, T, F>; 2], rows: &mut [T]) {
        if let (Some(v), Some(w)) = (self.span.vector(v), self.span.vector(w)) {
            put(rows, self.span.row, constant.curvature(v, w));
        }
    }

    #[inline(always)]
    fn input_rate(&self, constant: &Self::Constant, inputs: &Inputs<'_, T, F>, rows: &mut [T]) {
        if let Some([vector, rate]) = self.span.moved(inputs) {
            put(rows, self.span.row, dot(constant.gradient(vector), rate));
        }
    }
}
