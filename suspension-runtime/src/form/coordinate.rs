//! A prescribed coordinate, or difference of two.

use nalgebra::{SMatrix, Vector3};
use suspension_core::Scalar;

use crate::site::{CHASSIS, Sites};
use crate::table::Table;

/// A prescribed coordinate, or difference of two: one row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Coordinate {
    pub(crate) row: u16,
    pub(crate) drive: u16,
    axis: u16,
    /// Sites.
    of: u16,
    minus: Option<u16>,
    /// The columns of both, where they are free.
    columns: [Option<usize>; 2],
    /// Where the factors hold the derivatives by them.
    entries: [u16; 2],
}

impl Coordinate {
    /// Of two sites the second is subtracted.
    pub(crate) fn new(
        row: usize,
        drive: u16,
        axis: usize,
        [of, minus]: [Option<u16>; 2],
                entry: impl Fn(usize, usize) -> u16,
    ) -> Self {
        let column = |site: Option<u16>| {
            site.filter(|site| site & CHASSIS == 0).map(|site| usize::from(site) + axis)
        };
        let columns = [of, minus].map(column);
        Self {
            row: u16::try_from(row).unwrap_or(u16::MAX),
            drive,
            axis: u16::try_from(axis).unwrap_or(u16::MAX),
            of: of.unwrap_or(u16::MAX),
            minus,
            columns,
            entries: columns.map(|column| entry(row, column.unwrap_or(usize::MAX))),
        }
    }

    /// How far the coordinate is from the drive's value.
    #[inline(always)]
    pub(crate) fn residual<T: Scalar>(&self, sites: &Sites<'_, T, impl Table<Vector3<T>>>, drive: T) -> Option<T> {
        let of = along(sites.get(self.of)?, self.axis);
        Some(match self.minus {
            Some(minus) => of - along(sites.get(minus)?, self.axis) - drive,
            None => of - drive,
        })
    }

    /// What chassis points that move, and where it moves the drive, contribute to the row's rate; `moves` says which
    /// sites do.
    #[inline(always)]
    pub(crate) fn rate<T: Scalar>(
        &self,
        drive: Option<T>,
        moves: [bool; 2],
        rate: impl Fn(u16) -> Vector3<T>,
    ) -> T {
        let [of, minus] = moves;
        let minus = self.minus.filter(|_| minus).map(|minus| along(rate(minus), self.axis));
        let plus = match (drive, minus) {
            (Some(drive), Some(minus)) => Some(drive + minus),
            (one, other) => one.or(other),
        };
        match (plus, of.then(|| along(rate(self.of), self.axis))) {
            (Some(plus), Some(of)) => plus - of,
            (Some(plus), None) => plus,
            (None, Some(of)) => -of,
            (None, None) => -T::zero(),
        }
    }

    /// Which of its sites, beside those that are free, `moves` holds of.
    pub(crate) fn moves(&self, moves: impl Fn(u16) -> bool) -> [bool; 2] {
        [moves(self.of), self.minus.is_some_and(moves)]
    }

    /// Writes the derivatives into the factors.
    #[inline(always)]
    pub(crate) fn write<T: Scalar>(&self, entries: &mut impl Table<T>) {
        let [of, minus] = self.entries;
        *entries.place(of) = T::one();
        *entries.place(minus) = -T::one();
    }

    /// Writes the derivatives into a dense matrix.
    pub(crate) fn write_dense<T: Scalar, const N: usize>(&self, matrix: &mut SMatrix<T, N, N>) {
        for (column, value) in self.columns.into_iter().zip([T::one(), -T::one()]) {
            let place = column.map(|column| (usize::from(self.row), column));
            if let Some(entry) = place.and_then(|place| matrix.get_mut(place)) {
                *entry = value;
            }
        }
    }
}

#[inline(always)]
fn along<T: Scalar>(vector: Vector3<T>, axis: u16) -> T {
    match axis {
        0 => vector.x,
        1 => vector.y,
        _ => vector.z,
    }
}
