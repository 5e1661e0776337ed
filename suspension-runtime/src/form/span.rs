//! Two points, one row of equations about the vector between them, and where its derivatives are.

use nalgebra::{SMatrix, Vector3};
use suspension_core::Scalar;
use suspension_core::generated::difference;
use suspension_listing::system;

use crate::site::{Site, Sites};
use crate::table::{Table, index};

/// Two points that a row is about.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span {
    pub(crate) row: u16,
    pub(crate) from: Site,
    pub(crate) to: Site,
    /// Where the factors hold the derivatives by `to` and by `from`.
    entries: [[u16; 3]; 2],
}

impl Span {
    pub(super) fn new(
        [from, to]: [&system::Site; 2],
        row: usize,
        entry: impl Fn(usize, Option<usize>) -> u16,
    ) -> Self {
        let [from, to] = [from, to].map(Site::from);
        Self {
            row: index(row),
            from,
            to,
            entries: [to, from].map(|site| [0, 1, 2].map(|axis| entry(row, site.column(axis)))),
        }
    }

    /// From one point to the other, or its rate.
    #[inline(always)]
    pub(crate) fn vector<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<Vector3<T>> {
        Some(difference(sites.get(self.to)?, sites.get(self.from)?))
    }

    /// Writes the derivative by the vector into the factors.
    #[inline(always)]
    pub(super) fn write<T: Scalar>(&self, gradient: Vector3<T>, numbers: &mut impl Table<T>) {
        let [[a, b, c], [d, e, f]] = self.entries;
        *numbers.place(a) = gradient.x;
        *numbers.place(b) = gradient.y;
        *numbers.place(c) = gradient.z;
        *numbers.place(d) = -gradient.x;
        *numbers.place(e) = -gradient.y;
        *numbers.place(f) = -gradient.z;
    }

    /// Writes it into a dense matrix.
    pub(super) fn write_dense<T: Scalar, const N: usize>(
        &self,
        gradient: Vector3<T>,
        matrix: &mut SMatrix<T, N, N>,
    ) {
        for (site, gradient) in [(self.to, gradient), (self.from, -gradient)] {
            for (axis, value) in gradient.iter().enumerate() {
                let column = site.column(axis);
                let place = column.map(|column| (usize::from(self.row), column));
                if let Some(entry) = place.and_then(|place| matrix.get_mut(place)) {
                    *entry = *value;
                }
            }
        }
    }
}
