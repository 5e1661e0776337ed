//! Free and chassis points under one numbering.

use nalgebra::{SVector, Vector3};
use suspension_core::Scalar;

use crate::table::Table;

/// Where the coordinates of a point are: three times its number, and of a chassis point this beside it.
pub(crate) const CHASSIS: u16 = 1 << 15;

/// The points that equations join, or their rates.
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

    /// The vector of a free site.
    #[inline(always)]
    pub(crate) fn free(&self, site: u16) -> Option<Vector3<T>> {
        let first = usize::from(site);
        let &[x, y, z] = self.free.get(first..first + 3)? else {
            return None;
        };
        Some(Vector3::new(x, y, z))
    }

    /// The vector of a chassis site.
    #[inline(always)]
    pub(crate) fn chassis(&self, site: u16) -> Vector3<T> {
        self.chassis.get(site)
    }

    /// The vector of a site.
    #[inline(always)]
    pub(crate) fn get(&self, site: u16) -> Option<Vector3<T>> {
        if site & CHASSIS == 0 { self.free(site) } else { Some(self.chassis(site)) }
    }
}
