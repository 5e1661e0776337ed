//! Two points, one row of equations about the vector between them, and where its derivatives are.

use nalgebra::Vector3;
use suspension_core::Scalar;
use suspension_core::generated::difference;
use suspension_listing::system;

use super::{Entries, Place, put_vector};
use crate::site::{Inputs, Site, Sites};
use crate::table::{Table, index};

/// Two points whose difference a row contains.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span {
    pub(crate) row: u16,
    pub(crate) from: Site,
    pub(crate) to: Site,
    /// The places of the derivatives with respect to `to` and to `from`.
    entries: [[u16; 3]; 2],
}

impl Span {
    pub(super) fn new([from, to]: [&system::Site; 2], place: &Place<'_>) -> Self {
        let [from, to] = [from, to].map(Site::from);
        Self {
            row: index(place.row),
            from,
            to,
            entries: [to, from].map(|site| place.site_entries(0, site)),
        }
    }

    /// The vector from one point to the other, or its rate.
    #[inline(always)]
    pub(crate) fn vector<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<Vector3<T>> {
        Some(difference(sites.get(self.to)?, sites.get(self.from)?))
    }

    /// The vector, and the rate of its start if that is moved.
    #[inline(always)]
    pub(super) fn moved<T: Scalar>(
        &self,
        inputs: &Inputs<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<[Vector3<T>; 2]> {
        let rate = inputs.rate(self.from)?;
        Some([self.vector(&inputs.at)?, rate])
    }

    /// Writes the derivative with respect to the vector.
    #[inline(always)]
    pub(super) fn put<T: Scalar>(&self, gradient: Vector3<T>, to: &mut impl Entries<T>) {
        let [by_to, by_from] = self.entries;
        put_vector(by_to, gradient, to);
        put_vector(by_from, -gradient, to);
    }
}
