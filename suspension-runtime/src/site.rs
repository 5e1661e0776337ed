//! Free and chassis points under one numbering.

use nalgebra::{SVector, Vector3};
use suspension_core::Scalar;
use suspension_listing::system;

use crate::table::Table;
use crate::table::index;

/// A free or a chassis point: where its coordinates are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Site {
    /// The first of its unknowns.
    Free(u16),
    /// Its number among the chassis points.
    Chassis(u16),
}

impl From<&system::Site> for Site {
    fn from(site: &system::Site) -> Self {
        match site.first_column() {
            Some(column) => Self::Free(index(column)),
            None => Self::Chassis(index(site.index)),
        }
    }
}

impl Site {
    /// The column of a coordinate, where it is an unknown.
    pub(crate) fn column(self, axis: usize) -> Option<usize> {
        match self {
            Self::Free(first) => Some(usize::from(first) + axis),
            Self::Chassis(_) => None,
        }
    }
}

/// Positions of the points that equations join, or rates.
#[derive(Clone, Copy)]
pub(crate) struct Sites<'a, T, F> {
    free: &'a [T],
    chassis: &'a F,
}

impl<'a, T: Scalar, F: Table<Vector3<T>>> Sites<'a, T, F> {
    #[inline(always)]
    pub(crate) fn new<const N: usize>(q: &'a SVector<T, N>, chassis: &'a F) -> Self {
        let [free] = &q.data.0;
        Self { free, chassis }
    }

    /// The vector of a site. There is one for each site of the listing.
    #[inline(always)]
    pub(crate) fn get(&self, site: Site) -> Option<Vector3<T>> {
        match site {
            Site::Free(first) => three(self.free, first),
            Site::Chassis(point) => Some(self.chassis.get(point)),
        }
    }

    /// An unknown that is no coordinate.
    #[inline(always)]
    pub(crate) fn scalar(&self, unknown: u16) -> Option<T> {
        self.free.get(usize::from(unknown)).copied()
    }

    /// The vectors of three.
    #[inline(always)]
    pub(crate) fn get_each(&self, [a, b, c]: [Site; 3]) -> Option<[Vector3<T>; 3]> {
        Some([self.get(a)?, self.get(b)?, self.get(c)?])
    }
}

/// Three numbers in a row.
#[inline(always)]
pub(crate) fn three<T: Scalar>(numbers: &[T], first: u16) -> Option<Vector3<T>> {
    let first = usize::from(first);
    match numbers.get(first..first + 3)? {
        &[x, y, z] => Some(Vector3::new(x, y, z)),
        _ => None,
    }
}
