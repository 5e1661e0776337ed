//! The points that a body carries.

use nalgebra::{Matrix3, SMatrix, Vector3};
use suspension_core::Scalar;
use suspension_core::constraint::{self, Frame};

use super::columns;
use crate::site::Sites;
use crate::table::Table;

/// A body: the frame of three points, and the others.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    /// Sites.
    pub(crate) frame: [u16; 3],
    pub(crate) carried: Vec<Carried>,
}

/// A point carried by a frame: three rows.
#[derive(Clone, Debug)]
pub(crate) struct Carried {
    /// The first of its rows.
    pub(crate) row: u16,
    /// Its site.
    pub(crate) point: u16,
    /// The columns of the frame's points and of its own.
    columns: [Option<[usize; 3]>; 4],
    /// Where the factors hold the derivatives, row by row, by the frame's points and by its own; none
    /// where elimination takes the point out first.
    entries: Option<[[u16; 10]; 3]>,
}

impl Body {
    pub(crate) fn new(frame: [u16; 3]) -> Self {
        let carried = Vec::new();
        Self { frame, carried }
    }

    pub(crate) fn carry(
        &mut self,
        row: usize,
        point: u16,
                entry: Option<impl Fn(usize, usize) -> u16>,
    ) {
        let [a, b, c] = self.frame;
        let columns = [a, b, c, point].map(|site| columns(site));
        let of_row = |axis: usize, entry: &dyn Fn(usize, usize) -> u16| {
            let mut each = columns.iter().flat_map(|columns| columns.unwrap_or([usize::MAX; 3]));
            let frame = [(); 9].map(|()| each.next().unwrap_or(usize::MAX));
            let own = each.nth(axis).unwrap_or(usize::MAX);
            let mut all = frame.into_iter().chain([own]);
            [(); 10].map(|()| entry(row + axis, all.next().unwrap_or(usize::MAX)))
        };
        self.carried.push(Carried {
            row: u16::try_from(row).unwrap_or(u16::MAX),
            point,
            columns,
            entries: entry.map(|entry| [0, 1, 2].map(|axis| of_row(axis, &entry))),
        });
    }

    /// The frame as it stands, or of rates.
    #[inline(always)]
    pub(crate) fn frame<T: Scalar>(&self, sites: &Sites<'_, T, impl Table<Vector3<T>>>) -> Option<Frame<T>> {
        frame(self.frame, sites)
    }
}

/// The frame of three sites.
#[inline(always)]
pub(crate) fn frame<T: Scalar>([a, b, c]: [u16; 3], sites: &Sites<'_, T, impl Table<Vector3<T>>>) -> Option<Frame<T>> {
    Some(Frame::new(sites.get(a)?, sites.get(b)?, sites.get(c)?))
}

impl Carried {
    /// Writes the derivatives into the factors, where they are there.
    #[inline(always)]
    pub(crate) fn write<T: Scalar>(
        &self,
        constant: &constraint::Carried<T>,
        frame: &Frame<T>,
        entries: &mut impl Table<T>,
    ) {
        let Some(places) = &self.entries else {
            return;
        };
        let gradient = constant.gradient(frame);
        let blocks = [gradient.origin, gradient.second, gradient.third];
        for (axis, places) in places.iter().enumerate() {
            let of_row = blocks.iter().flat_map(|block| row(block, axis));
            for (place, value) in places.iter().zip(of_row.chain([T::one()])) {
                *entries.place(*place) = value;
            }
        }
    }

    /// Writes the derivatives into a dense matrix.
    pub(crate) fn write_dense<T: Scalar, const N: usize>(
        &self,
        constant: &constraint::Carried<T>,
        frame: &Frame<T>,
        matrix: &mut SMatrix<T, N, N>,
    ) {
        let gradient = constant.gradient(frame);
        let own = Matrix3::from_diagonal_element(T::one());
        let blocks = [gradient.origin, gradient.second, gradient.third, own];
        for (columns, block) in self.columns.iter().zip(&blocks) {
            for (axis, column) in columns.iter().flatten().enumerate() {
                for (below, value) in block.column(axis).iter().enumerate() {
                    if let Some(entry) = matrix.get_mut((usize::from(self.row) + below, *column)) {
                        *entry = *value;
                    }
                }
            }
        }
    }
}

#[inline(always)]
fn row<T: Scalar>(block: &Matrix3<T>, axis: usize) -> [T; 3] {
    match axis {
        0 => [block.m11, block.m12, block.m13],
        1 => [block.m21, block.m22, block.m23],
        _ => [block.m31, block.m32, block.m33],
    }
}
