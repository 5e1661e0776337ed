//! `Product`: two lines at an angle that stays.

use nalgebra::{SMatrix, Vector3};
use suspension_core::Scalar;
use suspension_core::constraint;
use suspension_core::generated::{difference, dot};
use suspension_listing::form;

use crate::plan::{LengthNames, LineLength};
use crate::site::{Site, Sites};
use crate::table::{Table, index};

/// Two lines at an angle: one row.
#[derive(Clone, Debug)]
pub(crate) struct Product {
    pub(crate) row: u16,
    pub(crate) lines: [[Site; 2]; 2],
    /// What keeps the length of each line.
    pub(crate) lengths: [LineLength; 2],
    /// Where the factors hold the derivatives by the ends of each line.
    entries: [[[u16; 3]; 2]; 2],
}

impl Product {
    pub(crate) fn new(
        form: &form::Product,
        row: usize,
        lengths: &LengthNames<'_>,
        entry: impl Fn(usize, Option<usize>) -> u16,
    ) -> Self {
        let lines = form.lines.each_ref().map(|line| line.each_ref());
        let sites = lines.map(|line| line.map(Site::from));
        let of_site = |site: Site| [0, 1, 2].map(|axis| entry(row, site.column(axis)));
        Self {
            row: index(row),
            lines: sites,
            lengths: lines.map(|line| lengths.of_line(line)),
            entries: sites.map(|line| line.map(of_site)),
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

    /// By each of the lines.
    #[inline(always)]
    fn gradient<T: Scalar>(
        &self,
        constant: &constraint::Product<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<[Vector3<T>; 2]> {
        let [first, second] = self.vectors(sites)?;
        Some([second, first].map(|other| constant.gradient(other)))
    }

    /// What the moved ends of the lines contribute to the rates: `-dF/du udot`.
    #[inline(always)]
    pub(crate) fn input_rate<T: Scalar, F: Table<Vector3<T>>>(
        &self,
        constant: &constraint::Product<T>,
        moved: [[bool; 2]; 2],
        sites: &Sites<'_, T, F>,
        rates: &Sites<'_, T, F>,
    ) -> Option<T> {
        let mut sum = None;
        let gradient = self.gradient(constant, sites)?;
        for ((line, gradient), moved) in self.lines.iter().zip(gradient).zip(moved) {
            let signs = [T::one(), -T::one()];
            for ((site, sign), _) in line
                .iter()
                .zip(signs)
                .zip(moved)
                .filter(|(_, moved)| *moved)
            {
                let term = sign * dot(gradient, rates.get(*site)?);
                sum = Some(sum.map_or(term, |sum| sum + term));
            }
        }
        sum
    }

    /// Writes the derivatives into the factors.
    #[inline(always)]
    pub(crate) fn write<T: Scalar>(
        &self,
        constant: &constraint::Product<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        numbers: &mut impl Table<T>,
    ) {
        let Some(gradient) = self.gradient(constant, sites) else {
            return;
        };
        for ([from, to], gradient) in self.entries.iter().zip(gradient) {
            for ((from, to), value) in from.iter().zip(to).zip(gradient.iter()) {
                *numbers.place(*from) = -*value;
                *numbers.place(*to) = *value;
            }
        }
    }

    /// Writes the derivatives into a dense matrix.
    pub(crate) fn write_dense<T: Scalar, const N: usize>(
        &self,
        constant: &constraint::Product<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        matrix: &mut SMatrix<T, N, N>,
    ) {
        let Some(gradient) = self.gradient(constant, sites) else {
            return;
        };
        for ([from, to], gradient) in self.lines.iter().zip(gradient) {
            for (site, gradient) in [(from, -gradient), (to, gradient)] {
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
}
