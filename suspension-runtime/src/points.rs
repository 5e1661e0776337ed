//! All points and their rates from the unknowns, and the unknowns from points.

use nalgebra::{SVector, Vector3};
use suspension_core::model::constraint::{Carried, Frame};
use suspension_core::{Scalar, Values};

use crate::equations::rows;
use crate::form::{Walked, walk};
use crate::model::Model;
use crate::site::{Site, Sites};
use crate::size::{Chassis, Points, Room, Size};
use crate::table::Table;

impl<T: Scalar, const N: usize> Model<'_, T, N>
where
    Room<N>: Size,
{
    /// Chassis points, free points, and markers, each made from the sites that carry it.
    pub(crate) fn all_points(
        &self,
        q: &SVector<T, N>,
        fixed: &Chassis<T, N>,
        marker: impl Fn(&Carried<T>, [Site; 3], &Frame<T>) -> Vector3<T>,
    ) -> Points<Vector3<T>, N> {
        let plan = self.plan();
        let sites = Sites::new(q.as_slice(), fixed);
        let [free] = &q.data.0;
        let (free, _) = free.as_chunks();
        let mut points = Points::<Vector3<T>, N>::default();
        let mut places = points.as_mut_slice().iter_mut();
        let chassis = fixed.as_slice().iter().take(plan.chassis.into());
        for (point, place) in chassis.zip(&mut places) {
            *place = *point;
        }
        for (&[x, y, z], place) in free.iter().take(plan.free.into()).zip(&mut places) {
            *place = Vector3::new(x, y, z);
        }
        let markers = plan.markers.iter().zip(self.markers.as_slice());
        for ((carriers, constant), place) in markers.zip(&mut places) {
            if let Some([a, b, c]) = sites.get_each(*carriers) {
                *place = marker(constant, *carriers, &Frame::new(a, b, c));
            }
        }
        points
    }

    /// Adds the effect of forces at markers to the forces at the points that carry them.
    pub(crate) fn carry_forces(
        &self,
        q: &SVector<T, N>,
        fixed: &Chassis<T, N>,
        forces: &mut Points<Vector3<T>, N>,
    ) {
        let plan = self.plan();
        let sites = Sites::new(q.as_slice(), fixed);
        let markers = plan.markers.iter().zip(self.markers.as_slice());
        for (marker, (carriers, constant)) in (plan.chassis + plan.free..).zip(markers) {
            if let Some([a, b, c]) = sites.get_each(*carriers) {
                let parts = constant.by_frame(forces.get(marker), &Frame::new(a, b, c));
                for (site, part) in carriers.iter().zip(parts) {
                    *forces.place(self.point(*site)) += part;
                }
            }
        }
    }

    /// The frame of three sites among all points.
    pub(crate) fn frame_of(&self, sites: [Site; 3], points: &Points<Vector3<T>, N>) -> Frame<T> {
        let [a, b, c] = sites.map(|site| points.get(self.point(site)));
        Frame::new(a, b, c)
    }

    /// The index of a site among all points.
    pub(crate) fn point(&self, site: Site) -> u16 {
        match site {
            Site::Free(first) => self.plan().chassis + first / 3,
            Site::Chassis(point) => point,
        }
    }

    pub(crate) fn unknowns(&self, points: &Points<Vector3<T>, N>) -> SVector<T, N> {
        let plan = self.plan();
        let free = (0..plan.free).map(|free| points.get(plan.chassis + free));
        let mut q = SVector::from([T::zero(); N]);
        let [places] = &mut q.data.0;
        let (places, _) = places.as_chunks_mut();
        for ([x, y, z], point) in places.iter_mut().zip(free) {
            (*x, *y, *z) = (point.x, point.y, point.z);
        }
        let chassis = points.values().take(plan.chassis.into());
        self.put_scalars(&mut q, &Chassis::<_, N>::from_values(chassis));
        q
    }

    /// Sets the unknowns that are not coordinates.
    pub(crate) fn put_scalars(&self, q: &mut SVector<T, N>, fixed: &Chassis<T, N>) {
        let q = rows(q);
        walk!(self.forms(), all(), self, |form, constant| {
            form.put_scalars(constant, q, fixed)
        });
    }
}
