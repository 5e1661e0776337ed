//! `Carried`: the points of a body beside those of its frame.

use nalgebra::{Matrix3, SMatrix, Vector3};
use suspension_core::Scalar;
use suspension_core::constraint::{self, Frame};
use suspension_listing::form;
use suspension_listing::system::{self, pair_name};

use crate::plan::LengthNames;
use crate::site::{Site, Sites};
use crate::table::Table;
use crate::table::index;

/// A body: the frame of three points, and those that it carries.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub(crate) frame: [Site; 3],
    /// The lengths of the frame's edges: first-second, first-third, second-third; `None` where both ends are
    /// on the chassis.
    pub(crate) edges: [Option<u16>; 3],
    pub(crate) carried: Vec<Carried>,
}

/// A point carried by a frame: three rows.
#[derive(Clone, Debug)]
pub(crate) struct Carried {
    /// The first of its rows.
    pub(crate) row: u16,
    pub(crate) point: Site,
    /// The lengths to the frame's points.
    pub(crate) reaches: [u16; 3],
    /// Where the factors hold the derivatives of each row, by the frame's points and by the point's own
    /// coordinate; `None` where elimination takes the point out first.
    entries: Option<[[u16; 10]; 3]>,
}

impl Body {
    pub(crate) fn new(body: &system::Body, lengths: &LengthNames<'_>) -> Self {
        Self {
            frame: body.frame.each_ref().map(Site::from),
            edges: (body.frame_pairs()).map(|ends| lengths.of_body(&body.name, ends)),
            carried: Vec::new(),
        }
    }

    /// Adds a point that it carries.
    pub(crate) fn carry(
        &mut self,
        form: &form::Carried,
        row: usize,
        lengths: &LengthNames<'_>,
        entry: Option<impl Fn(usize, Option<usize>) -> u16>,
    ) {
        let point = Site::from(&form.point);
        let entries = entry.map(|entry| {
            [0, 1, 2].map(|axis| {
                let frame = self.frame.iter();
                let of_frame = frame.flat_map(|site| [0, 1, 2].map(|axis| site.column(axis)));
                let mut columns = of_frame.chain([point.column(axis)]);
                [(); 10].map(|()| entry(row + axis, columns.next().flatten()))
            })
        });
        self.carried.push(Carried {
            row: index(row),
            point,
            reaches: (form.frame.each_ref()).map(|corner| {
                lengths.place(&pair_name(&form.body, &form.point.name, &corner.name))
            }),
            entries,
        });
    }

    /// The frame as it stands, or of rates.
    #[inline(always)]
    pub(crate) fn frame<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<Frame<T>> {
        let [a, b, c] = sites.get_each(self.frame)?;
        Some(Frame::new(a, b, c))
    }
}

impl Carried {
    /// Writes the derivatives into the factors, where they hold them.
    #[inline(always)]
    pub(crate) fn write<T: Scalar>(
        &self,
        constant: &constraint::Carried<T>,
        frame: &Frame<T>,
        numbers: &mut impl Table<T>,
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
                *numbers.place(*entry) = value;
            }
        }
    }

    /// Writes the derivatives into a dense matrix.
    pub(crate) fn write_dense<T: Scalar, const N: usize>(
        &self,
        constant: &constraint::Carried<T>,
        of: [Site; 3],
        frame: &Frame<T>,
        matrix: &mut SMatrix<T, N, N>,
    ) {
        let gradient = constant.gradient(frame);
        let own = (self.point, Matrix3::from_diagonal_element(T::one()));
        let blocks = [gradient.origin, gradient.second, gradient.third];
        for (site, block) in of.into_iter().zip(blocks).chain([own]) {
            for (axis, derivatives) in block.column_iter().enumerate() {
                let Some(column) = site.column(axis) else {
                    continue;
                };
                for (row, derivative) in (usize::from(self.row)..).zip(derivatives.iter()) {
                    if let Some(entry) = matrix.get_mut((row, column)) {
                        *entry = *derivative;
                    }
                }
            }
        }
    }
}
