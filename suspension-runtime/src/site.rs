//! Free and chassis points under one numbering.

use nalgebra::Vector3;
use suspension_core::Scalar;
use suspension_listing::system;

use crate::table::{Table, index};

/// A free or a chassis point: the place of its coordinates.
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
    /// The column of a coordinate, if it is an unknown.
    pub(crate) fn column(self, axis: usize) -> Option<usize> {
        match self {
            Self::Free(first) => Some(usize::from(first) + axis),
            Self::Chassis(_) => None,
        }
    }
}

/// Positions, or rates, of the points that equations join.
#[derive(Clone, Copy)]
pub(crate) struct Sites<'a, T, F> {
    free: &'a [T],
    chassis: &'a F,
    drives: &'a [T],
}

impl<'a, T: Scalar, F: Table<Vector3<T>>> Sites<'a, T, F> {
    /// Sites without drives.
    #[inline(always)]
    pub(crate) fn new(q: &'a [T], chassis: &'a F) -> Self {
        Self {
            free: q,
            chassis,
            drives: &[],
        }
    }

    #[inline(always)]
    pub(crate) fn with(self, drives: &'a [T]) -> Self {
        Self { drives, ..self }
    }

    /// The vector of a site. Every site of the listing has one.
    #[inline(always)]
    pub(crate) fn get(&self, site: Site) -> Option<Vector3<T>> {
        match site {
            Site::Free(first) => three(self.free, first),
            Site::Chassis(point) => Some(self.chassis.get(point)),
        }
    }

    /// An unknown that is not a coordinate.
    #[inline(always)]
    pub(crate) fn scalar(&self, unknown: u16) -> Option<T> {
        self.free.get(usize::from(unknown)).copied()
    }

    #[inline(always)]
    pub(crate) fn drive(&self, drive: u16) -> Option<T> {
        self.drives.get(usize::from(drive)).copied()
    }

    /// The vectors of three sites.
    #[inline(always)]
    pub(crate) fn get_each(&self, [a, b, c]: [Site; 3]) -> Option<[Vector3<T>; 3]> {
        Some([self.get(a)?, self.get(b)?, self.get(c)?])
    }
}

/// Inputs of which some move: either the drives with the chassis points that they move, or the other chassis points.
#[derive(Clone, Copy)]
pub(crate) struct Inputs<'a, T, F> {
    pub(crate) at: Sites<'a, T, F>,
    pub(crate) chassis_rate: &'a F,
    /// Empty if drives do not move.
    pub(crate) drive_rate: &'a [T],
    /// Whether drives move each chassis point.
    pub(crate) driven: &'a [bool],
    pub(crate) are_driven: bool,
}

impl<T: Scalar, F: Table<Vector3<T>>> Inputs<'_, T, F> {
    /// The rate of a site that moves.
    #[inline(always)]
    pub(crate) fn rate(&self, site: Site) -> Option<Vector3<T>> {
        let Site::Chassis(point) = site else {
            return None;
        };
        let moves = self.driven.get(usize::from(point)) == Some(&self.are_driven);
        moves.then(|| self.chassis_rate.get(point))
    }
}

/// Three consecutive numbers.
#[inline(always)]
pub(crate) fn three<T: Scalar>(numbers: &[T], first: u16) -> Option<Vector3<T>> {
    let first = usize::from(first);
    match numbers.get(first..first + 3)? {
        &[x, y, z] => Some(Vector3::new(x, y, z)),
        _ => None,
    }
}
