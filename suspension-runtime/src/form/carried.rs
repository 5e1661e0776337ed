//! `Carried`: the points of a body outside its frame.

use nalgebra::Vector3;
use suspension_core::Scalar;
use suspension_core::model::constraint::{self, Frame};
use suspension_listing::form;
use suspension_listing::system::{self, pair_name};

use super::{Entries, Place, Walked};
use crate::plan::lengths::LengthNames;
use crate::site::{Inputs, Site, Sites};
use crate::table::{SPARE, Table, index, put_three};

/// A body: the frame of three points, and the points that it carries.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub(crate) frame: [Site; 3],
    /// The lengths of the frame's edges: first-second, first-third, second-third; `None` if both ends are on the
    /// chassis.
    pub(crate) edges: [Option<u16>; 3],
    pub(crate) carried: Vec<Carried>,
}

/// A point carried by a frame: three rows.
#[derive(Clone, Debug)]
pub(crate) struct Carried {
    /// The first of its rows.
    pub(crate) row: u16,
    /// The index of its constant among those of the points that all bodies carry.
    pub(super) constant: u16,
    pub(crate) point: Site,
    /// The lengths to the frame's points.
    pub(crate) reaches: [u16; 3],
    /// The places of each row's derivatives, with respect to the frame's points and to the point's own coordinate;
    /// `None` in factors that take the point out first.
    entries: Option<[[u16; 10]; 3]>,
}

impl Body {
    pub(crate) fn new(body: &system::Body, lengths: &LengthNames<'_>) -> Self {
        Self {
            frame: body.frame.each_ref().map(Site::from),
            edges: (body.frame_pairs()).map(|ends| lengths.body_length(&body.name, ends)),
            carried: Vec::new(),
        }
    }

    /// Adds a carried point.
    pub(super) fn carry(&mut self, form: &form::Carried, place: &Place<'_>) {
        let point = Site::from(&form.point);
        let entries = [0, 1, 2].map(|axis| {
            let frame = self.frame.iter();
            let of_frame = frame.flat_map(|site| [0, 1, 2].map(|axis| site.column(axis)));
            let mut columns = of_frame.chain([point.column(axis)]);
            [(); 10].map(|()| place.entry(axis, columns.next().flatten()))
        });
        let are_held = entries.as_flattened().iter().any(|entry| *entry != SPARE);
        self.carried.push(Carried {
            row: index(place.row),
            constant: SPARE,
            point,
            reaches: (form.frame.each_ref()).map(|corner| {
                let name = pair_name(&form.body, &form.point.name, &corner.name);
                place.lengths.place(&name)
            }),
            entries: are_held.then_some(entries),
        });
    }

    /// The carried points, each with its constant.
    #[inline(always)]
    fn carried_with_constants<'a, C>(
        &'a self,
        constants: &'a [C],
    ) -> impl Iterator<Item = (&'a Carried, &'a C)> {
        let carried = self.carried.iter();
        carried.filter_map(|carried| Some((carried, constants.get(usize::from(carried.constant))?)))
    }

    /// The present frame, or its rates; `None` if it carries nothing.
    #[inline(always)]
    pub(crate) fn frame<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<Frame<T>> {
        if self.carried.is_empty() {
            return None;
        }
        let [a, b, c] = sites.get_each(self.frame)?;
        Some(Frame::new(a, b, c))
    }
}

impl Carried {
    /// Writes the derivatives to their places.
    #[inline(always)]
    fn gradient<T: Scalar>(
        &self,
        constant: &constraint::Carried<T>,
        frame: &Frame<T>,
        to: &mut impl Entries<T>,
    ) {
        let Some([x, y, z]) = &self.entries else {
            return;
        };
        let gradient = constant.gradient(frame);
        let (a, b, c) = (gradient.origin, gradient.second, gradient.third);
        let one = T::one();
        let rows = [
            [
                a.m11, a.m12, a.m13, b.m11, b.m12, b.m13, c.m11, c.m12, c.m13, one,
            ],
            [
                a.m21, a.m22, a.m23, b.m21, b.m22, b.m23, c.m21, c.m22, c.m23, one,
            ],
            [
                a.m31, a.m32, a.m33, b.m31, b.m32, b.m33, c.m31, c.m32, c.m33, one,
            ],
        ];
        for (entries, values) in [x, y, z].into_iter().zip(rows) {
            for (entry, value) in entries.iter().zip(values) {
                to.put(*entry, value);
            }
        }
    }
}

impl<T: Scalar, F: Table<Vector3<T>>> Walked<T, F> for Body {
    type Constant = [constraint::Carried<T>];

    #[inline(always)]
    fn residual(&self, constants: &Self::Constant, at: &Sites<'_, T, F>, rows: &mut [T]) {
        let Some(frame) = self.frame(at) else {
            return;
        };
        for (carried, constant) in self.carried_with_constants(constants) {
            if let Some(point) = at.get(carried.point) {
                put_three(rows, carried.row, constant.residual(point, &frame));
            }
        }
    }

    #[inline(always)]
    fn gradient(&self, constants: &Self::Constant, at: &Sites<'_, T, F>, to: &mut impl Entries<T>) {
        let Some(frame) = self.frame(at) else {
            return;
        };
        for (carried, constant) in self.carried_with_constants(constants) {
            carried.gradient(constant, &frame, to);
        }
    }

    #[inline(always)]
    fn curvature(&self, constants: &Self::Constant, [v, w]: [&Sites<'_, T, F>; 2], rows: &mut [T]) {
        let (Some(v), Some(w)) = (self.frame(v), self.frame(w)) else {
            return;
        };
        for (carried, constant) in self.carried_with_constants(constants) {
            put_three(rows, carried.row, constant.curvature(&v, &w));
        }
    }

    #[inline(never)]
    fn input_rate(&self, constants: &Self::Constant, inputs: &Inputs<'_, T, F>, rows: &mut [T]) {
        let Some(frame) = self.frame(&inputs.at) else {
            return;
        };
        let rates = self.frame.map(|site| inputs.rate(site));
        for (carried, constant) in self.carried_with_constants(constants) {
            let gradient = constant.gradient(&frame);
            let blocks = [gradient.origin, gradient.second, gradient.third];
            let terms = blocks.into_iter().zip(rates);
            let mut terms = terms.filter_map(|(block, rate)| Some((block, rate?)));
            if let Some((block, rate)) = terms.next() {
                let less = |sum, (block, rate)| sum - block * rate;
                put_three(rows, carried.row, terms.fold(-block * rate, less));
            }
        }
    }
}
