//! A guess with each rigid body, and each cluster of links that is as rigid, put where it fits best.

use nalgebra::{SVector, Vector3};
use suspension_core::Real;
use suspension_core::model::constraint::Frame;
use suspension_core::solve::assemble;

use crate::model::Model;
use crate::site::{Site, Sites};
use crate::size::{Chassis, Room, Size};
use crate::table::Table;

impl<T: Real, const N: usize> Model<'_, T, N>
where
    Room<N>: Size,
{
    /// The guess `q` with each body, and each cluster of links, moved to where it fits best.
    pub(crate) fn fit(&self, q: &SVector<T, N>, fixed: &Chassis<T, N>) -> SVector<T, N> {
        let plan = self.plan();
        let mut q = *q;
        let mut carried = self.carried.as_slice().iter();
        for (body, frame) in self.forms().bodies.iter().zip(self.frames.as_slice()) {
            let points = body.carried.iter().map(|carried| carried.point);
            let shape = points.zip(carried.by_ref());
            let shape = shape.map(|(site, constant)| (site, constant.position(frame)));
            fit::<T, N>(
                &mut q,
                fixed,
                body.frame,
                frame,
                shape.take(body.carried.len()),
            );
        }
        let mut linked = self.linked.as_slice().iter();
        for (cluster, frame) in plan.clusters.iter().zip(self.cluster_frames.as_slice()) {
            let points = cluster.points.iter().map(|point| point.site);
            let shape = points.zip(linked.by_ref());
            let shape = shape.map(|(site, constant)| (site, constant.position(frame)));
            fit::<T, N>(&mut q, fixed, cluster.frame, frame, shape);
        }
        self.put_scalars(&mut q, fixed);
        q
    }
}

/// Moves the free points of a rigid shape (the sites of a frame and others) to where it fits `q` best.
fn fit<T: Real, const N: usize>(
    q: &mut SVector<T, N>,
    fixed: &Chassis<T, N>,
    of_frame: [Site; 3],
    frame: &Frame<T>,
    others: impl Iterator<Item = (Site, Vector3<T>)>,
) where
    Room<N>: Size,
{
    let mut sites = [None; N];
    let (mut shape, mut guess) = ([Vector3::zeros(); N], [Vector3::zeros(); N]);
    let mut count = 0;
    let at = Sites::new(q.as_slice(), fixed);
    let corners = of_frame.into_iter().zip(frame.points());
    let places = sites.iter_mut().zip(&mut shape).zip(&mut guess);
    for (((site_place, shape_place), guess_place), (site, position)) in
        places.zip(corners.chain(others))
    {
        (*site_place, *shape_place) = (Some(site), position);
        *guess_place = at.get(site).unwrap_or_default();
        count += 1;
    }
    let of_shape = shape.get(..count).zip(guess.get(..count));
    let motion = of_shape.and_then(|(shape, guess)| assemble::best_rigid_motion(shape, guess));
    let Some(motion) = motion else {
        return;
    };
    for (site, position) in sites.into_iter().flatten().zip(shape) {
        let moved = motion(position);
        for (axis, value) in moved.iter().enumerate() {
            if let Some(place) = site.column(axis).and_then(|column| q.get_mut(column)) {
                *place = *value;
            }
        }
    }
}
