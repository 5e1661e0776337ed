//! `Distance`: two points a constant length apart.

use nalgebra::{SMatrix, Vector3};
use suspension_core::Scalar;
use suspension_core::constraint;
use suspension_core::generated::difference;
use suspension_listing::form;

use crate::site::{Site, Sites};
use crate::table::Table;
use crate::table::index;

/// A constant length: one row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Distance {
    pub(crate) row: u16,
    /// Its place among the lengths.
    pub(crate) length: u16,
    pub(crate) from: Site,
    pub(crate) to: Site,
    /// Where the factors hold the derivatives by `to` and by `from`.
    entries: [[u16; 3]; 2],
}

impl Distance {
    pub(crate) fn new(
        form: &form::Distance,
        row: usize,
        length: u16,
        entry: impl Fn(usize, Option<usize>) -> u16,
    ) -> Self {
        let [from, to] = [&form.from, &form.to].map(Site::from);
        Self {
            row: index(row),
            length,
            from,
            to,
            entries: [to, from].map(|site| [0, 1, 2].map(|axis| entry(row, site.column(axis)))),
        }
    }

    /// From one point to the other.
    #[inline(always)]
    pub(crate) fn vector<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<Vector3<T>> {
        Some(difference(sites.get(self.to)?, sites.get(self.from)?))
    }

    /// Writes the derivatives into the factors.
    #[inline(always)]
    pub(crate) fn write<T: Scalar>(
        &self,
        constant: &constraint::Distance<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        numbers: &mut impl Table<T>,
    ) {
        let Some(vector) = self.vector(sites) else {
            return;
        };
        let gradient = constant.gradient(vector);
        let [[a, b, c], [d, e, f]] = self.entries;
        *numbers.place(a) = gradient.x;
        *numbers.place(b) = gradient.y;
        *numbers.place(c) = gradient.z;
        *numbers.place(d) = -gradient.x;
        *numbers.place(e) = -gradient.y;
        *numbers.place(f) = -gradient.z;
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
        for (site, gradient) in [(self.to, gradient), (self.from, -gradient)] {
            for (axis, value) in gradient.iter().enumerate() {
                let place = site
                    .column(axis)
                    .map(|column| (usize::from(self.row), column));
                if let Some(entry) = place.and_then(|place| matrix.get_mut(place)) {
                    *entry = *value;
                }
            }
        }
    }
}
