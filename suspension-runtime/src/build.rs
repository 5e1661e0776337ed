//! The model from positions or lengths.

use nalgebra::Vector3;
use suspension_core::Real;
use suspension_core::constraint::{Carried, Distance, Frame};

use crate::listing::Listing;
use crate::model::{Few, Model};
use crate::size::{Room, Size};
use crate::table::Table;

impl<'l, T: Real, const N: usize> Model<'l, T, N>
where
    Room<N>: Size,
{
    /// From all points.
    pub fn scratch(listing: &'l Listing, points: &[Vector3<T>]) -> Self {
        let plan = &listing.plan;
        let zero = Vector3::zeros();
        let point = |site: u16| {
            if site < 1 << 15 { points[usize::from(plan.chassis + site / 3)] } else { points[usize::from(site - (1 << 15))] }
        };
        let mut fixed = Few::<Vector3<T>, N>::filled(zero);
        for (place, p) in fixed.as_mut_slice().iter_mut().zip(&points[..usize::from(plan.chassis)]) {
            *place = *p;
        }
        let mut distances = [Distance::new(T::one()); N];
        for (place, d) in distances.iter_mut().zip(&plan.distances) {
            *place = Distance::new((point(d.to) - point(d.from)).norm());
        }
        let mut frames = Few::<Frame<T>, N>::filled(Frame::new(zero, zero, zero));
        let mut carried = Few::<Carried<T>, N>::filled(Carried::default());
        let mut next = carried.as_mut_slice().iter_mut();
        for (place, body) in frames.as_mut_slice().iter_mut().zip(&plan.bodies) {
            let [a, b, c] = body.frame.map(point);
            *place = Frame::new(a, b, c);
            for (p, place_c) in body.carried.iter().zip(&mut next) {
                *place_c = Carried::new(point(p.point), place).unwrap();
            }
        }
        let size = distances.iter().take(plan.distances.len()).fold(T::zero(), |l, d| l.max(d.length()));
        Self {
            listing,
            fixed,
            size,
            distances,
            carried,
            markers: Few::<Carried<T>, N>::filled(Carried::default()),
            cluster_frames: frames,
            frames,
            linked: Few::<_, N>::filled(suspension_core::handedness::Linked::new(Carried::default(), &Frame::new(zero, zero, zero))),
        }
    }
}
