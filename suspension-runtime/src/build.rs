//! The model from positions.

use nalgebra::{SVector, Vector3};
use suspension_core::constraint::{Along, Carried, Distance, Frame, Stretch};
use suspension_core::generated::dot;
use suspension_core::handedness::Linked;
use suspension_core::{GeometryError, Real, Values, assemble, parts};

use crate::fitted::Fitted;
use crate::model::Model;
use crate::plan::Measure;
use crate::readout::coordinate;
use crate::site::{Site, Sites};
use crate::size::{Few, Points, Room, Size};
use crate::table::Table;

impl<'l, T: Real, const N: usize> Model<'l, T, N>
where
    Room<N>: Size,
{
    pub(crate) fn from_points(
        listing: Fitted<'l, N>,
        design: &Points<Vector3<T>, N>,
    ) -> Result<Self, GeometryError> {
        let plan = listing.plan();
        let chassis = design.as_slice().iter().take(plan.chassis.into());
        let model = Self {
            listing,
            fixed: Few::<_, N>::from_values(chassis.copied()),
            size: T::zero(),
            distances: [Distance::default(); N],
            frames: Default::default(),
            carried: Default::default(),
            along: Default::default(),
            stretches: Default::default(),
            markers: Default::default(),
            cluster_frames: Default::default(),
            linked: Default::default(),
        };
        parts::finite(model.points_of(design))?;
        let frames = model.frames_at(design)?;
        let cluster_frames = model.cluster_frames_at(design)?;
        let built = Self {
            frames,
            cluster_frames,
            distances: model.distances_at(design)?,
            carried: model.carried_at(design, &frames)?,
            along: model.along_at(design)?,
            stretches: model.stretches_at(design)?,
            linked: model.linked_at(design, &cluster_frames)?,
            markers: model.markers_at(design)?,
            ..model
        };
        Ok(built.sized())
    }

    /// The points that the listing has.
    fn points_of(&self, points: &Points<Vector3<T>, N>) -> impl Iterator<Item = Vector3<T>> {
        let plan = self.plan();
        let count = usize::from(plan.chassis + plan.free) + plan.markers.len();
        points.values().take(count)
    }

    fn frames_at(&self, design: &Points<Vector3<T>, N>) -> Result<Few<Frame<T>, N>, GeometryError> {
        fill(self.plan().bodies.iter().map(|body| {
            let [.., third] = body.frame;
            let third = usize::from(self.point(third));
            parts::frame(third, self.frame_of(body.frame, design))
        }))
    }

    fn cluster_frames_at(
        &self,
        design: &Points<Vector3<T>, N>,
    ) -> Result<Few<Frame<T>, N>, GeometryError> {
        fill(self.plan().clusters.iter().map(|cluster| {
            let [.., third] = cluster.frame;
            let third = usize::from(self.point(third));
            parts::frame(third, self.frame_of(cluster.frame, design))
        }))
    }

    fn distances_at(
        &self,
        design: &Points<Vector3<T>, N>,
    ) -> Result<[Distance<T>; N], GeometryError> {
        let mut distances = [Distance::default(); N];
        for (place, distance) in distances.iter_mut().zip(&self.plan().distances) {
            let [from, to] =
                [distance.span.from, distance.span.to].map(|site| design.get(self.point(site)));
            *place = parts::distance(distance.length.into(), from, to)?;
        }
        Ok(distances)
    }

    fn along_at(&self, design: &Points<Vector3<T>, N>) -> Result<Few<Along<T>, N>, GeometryError> {
        fill(self.plan().along.iter().map(|along| {
            let [from, to] = along.line.map(|site| self.point(site));
            parts::line(to.into(), (design.get(to) - design.get(from)).norm())
        }))
    }

    fn stretches_at(
        &self,
        design: &Points<Vector3<T>, N>,
    ) -> Result<Few<Stretch<T>, N>, GeometryError> {
        fill(self.plan().stretches.iter().map(|stretch| {
            let [from, to] = [stretch.span.from, stretch.span.to].map(|site| self.point(site));
            parts::stretch(to.into(), (design.get(to) - design.get(from)).norm())
        }))
    }

    fn carried_at(
        &self,
        design: &Points<Vector3<T>, N>,
        frames: &Few<Frame<T>, N>,
    ) -> Result<Few<Carried<T>, N>, GeometryError> {
        let bodies = self.plan().bodies.iter().zip(frames.as_slice());
        fill(bodies.flat_map(|(body, frame)| {
            body.carried.iter().map(move |carried| {
                let point = self.point(carried.point);
                parts::carried(point.into(), design.get(point), frame)
            })
        }))
    }

    fn linked_at(
        &self,
        design: &Points<Vector3<T>, N>,
        frames: &Few<Frame<T>, N>,
    ) -> Result<Few<Linked<T>, N>, GeometryError> {
        let clusters = self.plan().clusters.iter().zip(frames.as_slice());
        fill(clusters.flat_map(|(cluster, frame)| {
            let points = cluster.points.iter();
            points
                .map(move |point| parts::linked(point.point.into(), design.get(point.point), frame))
        }))
    }

    pub(crate) fn markers_at(
        &self,
        points: &Points<Vector3<T>, N>,
    ) -> Result<Few<Carried<T>, N>, GeometryError> {
        let plan = self.plan();
        let first = plan.chassis + plan.free;
        fill((first..).zip(&plan.markers).map(|(marker, carriers)| {
            let frame = self.frame_of(*carriers, points);
            parts::carried(marker.into(), points.get(marker), &frame)
        }))
    }

    pub(crate) fn marked(self, points: &Points<Vector3<T>, N>) -> Result<Self, GeometryError> {
        parts::finite(self.points_of(points))?;
        let markers = self.markers_at(points)?;
        Ok(Self { markers, ..self })
    }

    /// With `size` brought up to the other constants.
    pub(crate) fn sized(self) -> Self {
        let distances = self.distances.iter().take(self.plan().distances.len());
        let lines = self.along.as_slice().iter().take(self.plan().along.len());
        let stretches = self.stretches.as_slice().iter();
        let stretches = stretches.take(self.plan().stretches.len());
        let lengths = distances
            .map(Distance::length)
            .chain(lines.map(Along::length))
            .chain(stretches.map(Stretch::length));
        let size = lengths.fold(T::zero(), |longest, length| longest.max(length));
        Self { size, ..self }
    }

    pub(crate) fn drives_in(&self, points: &Points<Vector3<T>, N>) -> Few<T, N> {
        let drives = self.plan().drives.iter().map(|drive| match drive.quantity {
            Measure::Coordinate { axis, of, minus } => {
                let of = coordinate(&points.get(of), axis);
                minus.map_or(of, |minus| of - coordinate(&points.get(minus), axis))
            }
            Measure::Angle { axis, line } => {
                let [from, to] = line.map(|point| coordinate(&points.get(point), axis));
                let of = drive.angle_of.map(usize::from);
                let distance = of.and_then(|distance| self.distances.get(distance));
                let length = distance.map_or(T::zero(), Distance::length);
                parts::angle(to - from, length)
            }
            Measure::Length { line } => {
                let [from, to] = line.map(|point| points.get(point));
                (to - from).norm()
            }
            Measure::Along { point, direction } => {
                dot(points.get(point), direction.map(T::constant).into())
            }
        });
        Few::<T, N>::from_values(drives)
    }

    /// The guess `q` with each body, and each cluster of links, put where it fits best.
    pub(crate) fn fitted(&self, q: &SVector<T, N>, fixed: &Few<Vector3<T>, N>) -> SVector<T, N> {
        let plan = self.plan();
        let mut q = *q;
        let mut carried = self.carried.as_slice().iter();
        for (body, frame) in plan.bodies.iter().zip(self.frames.as_slice()) {
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
        for (along, constant) in plan.along.iter().zip(self.along.as_slice()) {
            let sites = Sites::new(&q, fixed);
            let ends = sites.get(along.point).zip(along.ends(&sites));
            let distance = ends.map(|(point, line)| constant.distance(point, line));
            if let Some((place, distance)) = q.get_mut(usize::from(along.distance)).zip(distance) {
                *place = distance;
            }
        }
        for (stretch, constant) in plan.stretches.iter().zip(self.stretches.as_slice()) {
            let length = stretch
                .span
                .vector(&Sites::new(&q, fixed))
                .map(|d| constant.reach(d));
            if let Some((place, length)) = q.get_mut(usize::from(stretch.length)).zip(length) {
                *place = length;
            }
        }
        q
    }
}

/// A table of results, up to the first error.
pub(crate) fn fill<V, F: Values<V>>(
    values: impl Iterator<Item = Result<V, GeometryError>>,
) -> Result<F, GeometryError>
where
    V: Default,
{
    let mut error = None;
    let table = F::from_values(values.map_while(|value| match value {
        Ok(value) => Some(value),
        Err(refused) => {
            error = Some(refused);
            None
        }
    }));
    error.map_or(Ok(table), Err)
}

/// Puts the free points of a rigid shape, the sites of a frame and others, where it fits `q` best.
fn fit<T: Real, const N: usize>(
    q: &mut SVector<T, N>,
    fixed: &Few<Vector3<T>, N>,
    of_frame: [Site; 3],
    frame: &Frame<T>,
    others: impl Iterator<Item = (Site, Vector3<T>)>,
) where
    Room<N>: Size,
{
    let mut sites = [None; N];
    let (mut shape, mut guess) = ([Vector3::zeros(); N], [Vector3::zeros(); N]);
    let mut count = 0;
    let at = Sites::new(q, fixed);
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
