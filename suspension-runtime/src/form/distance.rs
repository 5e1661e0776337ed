//! Two points a constant length apart.

use nalgebra::{SMatrix, Vector3};
use suspension_core::Scalar;
use suspension_core::constraint;
use suspension_core::generated::difference;

use super::columns;
use crate::site::{CHASSIS, Sites};
use crate::table::Table;

/// A constant length: one row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Distance {
    pub(crate) row: u16,
    /// Sites; of two where one is on the chassis, that is `from`.
    pub(crate) from: u16,
    pub(crate) to: u16,
    /// Where the factors hold the derivatives by `to` and by `from`.
    entries: [u16; 6],
    /// Whether `from` is on the chassis.
    hangs: bool,
}

impl Distance {
    pub(crate) fn new(
        row: usize,
        [from, to]: [u16; 2],
                entry: impl Fn(usize, usize) -> u16,
    ) -> Self {
        // Beyond all columns where there is none, so that no entry is found.
        let of = |site| columns(site).unwrap_or([usize::MAX; 3]);
        let ([a, b, c], [d, e, f]) = (of(to), of(from));
        Self {
            row: u16::try_from(row).unwrap_or(u16::MAX),
            from,
            to,
            entries: [a, b, c, d, e, f].map(|column| entry(row, column)),
            hangs: from & CHASSIS != 0,
        }
    }

    /// From one point to the other.
    #[inline(always)]
    pub(crate) fn vector<T: Scalar>(&self, sites: &Sites<'_, T, impl Table<Vector3<T>>>) -> Option<Vector3<T>> {
        let from = if self.hangs { sites.chassis(self.from) } else { sites.free(self.from)? };
        Some(difference(sites.free(self.to)?, from))
    }

    /// Writes the derivatives into the factors.
    #[inline(always)]
    pub(crate) fn write<T: Scalar>(
        &self,
        constant: &constraint::Distance<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        entries: &mut impl Table<T>,
    ) {
        let Some(vector) = self.vector(sites) else {
            return;
        };
        let gradient = constant.gradient(vector);
        let [a, b, c, d, e, f] = self.entries;
        *entries.place(a) = gradient.x;
        *entries.place(b) = gradient.y;
        *entries.place(c) = gradient.z;
        *entries.place(d) = -gradient.x;
        *entries.place(e) = -gradient.y;
        *entries.place(f) = -gradient.z;
    }

    /// Writes the derivatives into a dense matrix.
    pub(crate) fn write_dense<T: Scalar, const N: usize>(
        &self,
        constant: &constraint::Distance<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        matrix: &mut SMatrix<T, N, N>,
    ) {
        let Some(vector) = self.vector(sites) else {
            return;
        };
        let gradient = constant.gradient(vector);
        let mut write = |site: u16, value: Vector3<T>| {
            for (axis, value) in value.iter().enumerate() {
                let place = (usize::from(self.row), usize::from(site) + axis);
                if let Some(entry) = matrix.get_mut(place) {
                    *entry = *value;
                }
            }
        };
        write(self.to, gradient);
        if !self.hangs {
            write(self.from, -gradient);
        }
    }
}
