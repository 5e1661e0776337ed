//! The model from positions.

use nalgebra::Vector3;
use suspension_core::model::constraint::{
    Bilinear, Carried, Distance, Frame, Held, InPlane, OnLine, Product, Stretch, Turn,
};
use suspension_core::model::handedness::Linked;
use suspension_core::{GeometryError, Real, Values, model::parts};

use crate::fitted::Fitted;
use crate::model::Model;
use crate::site::Site;
use crate::size::{Chassis, Few, Points, Room, Size, Unknowns};
use crate::table::Table;

impl<'l, T: Real, const N: usize> Model<'l, T, N>
where
    Room<N>: Size,
{
    pub(crate) fn build(
        listing: Fitted<'l, N>,
        design: &Points<Vector3<T>, N>,
    ) -> Result<Self, GeometryError> {
        let plan = listing.plan();
        let chassis = design.as_slice().iter().take(plan.chassis.into());
        let fixed = Chassis::<_, N>::from_values(chassis.copied());
        let model = Self::with_chassis(listing, fixed);
        parts::finite(model.points_of(design))?;
        let bodies = model.forms().bodies.iter();
        let frames = model.frames_at(design, bodies.map(|body| body.frame))?;
        let clusters = plan.clusters.iter();
        let cluster_frames = model.frames_at(design, clusters.map(|cluster| cluster.frame))?;
        let built = Self {
            frames,
            cluster_frames,
            distances: model.distances_at(design)?,
            carried: model.carried_at(design, &frames)?,
            lines: model.lines_at(design)?,
            planes: model.planes_at(design)?,
            stretches: model.stretches_at(design)?,
            products: model.products_at(design)?,
            turns: model.turns_at(design)?,
            scales: model.scales_at(design)?,
            held: model.held_at(design),
            linked: model.linked_at(design, &cluster_frames)?,
            markers: model.markers_at(design)?,
            ..model
        };
        Ok(built.sized())
    }

    /// The points of the listing.
    fn points_of(&self, points: &Points<Vector3<T>, N>) -> impl Iterator<Item = Vector3<T>> {
        let plan = self.plan();
        let count = usize::from(plan.chassis + plan.free) + plan.markers.len();
        points.values().take(count)
    }

    /// The frames whose points are at these sites.
    fn frames_at(
        &self,
        design: &Points<Vector3<T>, N>,
        sites: impl Iterator<Item = [Site; 3]>,
    ) -> Result<Few<Frame<T>, N>, GeometryError> {
        fill(sites.map(|frame| {
            let [.., third] = frame;
            parts::frame(self.point(third).into(), self.frame_of(frame, design))
        }))
    }

    /// The vector from one site to another.
    fn vector_at(&self, design: &Points<Vector3<T>, N>, line: [Site; 2]) -> Vector3<T> {
        let [from, to] = line.map(|site| design.get(self.point(site)));
        to - from
    }

    fn distances_at(
        &self,
        design: &Points<Vector3<T>, N>,
    ) -> Result<Unknowns<Distance<T>, N>, GeometryError> {
        fill(self.forms().distances.iter().map(|distance| {
            let ends = [distance.span.from, distance.span.to];
            let [from, to] = ends.map(|site| design.get(self.point(site)));
            parts::distance(distance.length.into(), from, to)
        }))
    }

    fn lines_at(&self, design: &Points<Vector3<T>, N>) -> Result<Few<OnLine<T>, N>, GeometryError> {
        fill(self.forms().lines.iter().map(|line| {
            let [to] = line.ends;
            let length = self.vector_at(design, [line.from, to]).norm();
            parts::line(self.point(to).into(), length)
        }))
    }

    fn planes_at(
        &self,
        design: &Points<Vector3<T>, N>,
    ) -> Result<Few<InPlane<T>, N>, GeometryError> {
        fill(self.forms().planes.iter().map(|plane| {
            let [second, third] = plane.ends;
            let frame = self.frame_of([plane.from, second, third], design);
            parts::plane(self.point(third).into(), frame)
        }))
    }

    fn stretches_at(
        &self,
        design: &Points<Vector3<T>, N>,
    ) -> Result<Few<Stretch<T>, N>, GeometryError> {
        fill(self.forms().stretches.iter().map(|stretch| {
            let [from, to] = [stretch.span.from, stretch.span.to];
            let length = self.vector_at(design, [from, to]).norm();
            parts::stretch(self.point(to).into(), length)
        }))
    }

    fn products_at(
        &self,
        design: &Points<Vector3<T>, N>,
    ) -> Result<Few<Product<T>, N>, GeometryError> {
        fill(self.forms().products.iter().map(|product| {
            let [_, [_, end]] = product.lines;
            let lines = product.lines.map(|line| self.vector_at(design, line));
            parts::product(self.point(end).into(), lines)
        }))
    }

    fn turns_at(&self, design: &Points<Vector3<T>, N>) -> Result<Few<Turn<T>, N>, GeometryError> {
        fill(self.forms().turns.iter().map(|turn| {
            let [.., [_, end]] = turn.lines;
            let lines = turn.lines.map(|line| self.vector_at(design, line));
            parts::turn(self.point(end).into(), lines)
        }))
    }

    fn scales_at(
        &self,
        design: &Points<Vector3<T>, N>,
    ) -> Result<Few<Bilinear<T>, N>, GeometryError> {
        fill(self.forms().scales.iter().map(|scale| {
            let length = |line: &[Site; 2]| self.vector_at(design, *line).norm();
            let end = scale.lines.as_flattened().last();
            let end = end.map_or(usize::MAX, |end| self.point(*end).into());
            match scale.lines.as_slice() {
                [line] => parts::bilinear(end, [length(line)]),
                [first, second] => parts::bilinear(end, [first, second].map(length)),
                _ => Err(GeometryError::NoLine { point: end }),
            }
        }))
    }

    fn held_at(&self, design: &Points<Vector3<T>, N>) -> Few<Held<T>, N> {
        let sums = self.forms().held().map(|linear| {
            let terms = linear.terms.iter();
            let values = terms.map(|term| term.value(&design.get(self.point(term.site))));
            let sum = values.reduce(|sum, value| sum + value);
            Held::new(sum.unwrap_or_else(T::zero))
        });
        Few::<_, N>::from_values(sums)
    }

    fn carried_at(
        &self,
        design: &Points<Vector3<T>, N>,
        frames: &Few<Frame<T>, N>,
    ) -> Result<Few<Carried<T>, N>, GeometryError> {
        let bodies = self.forms().bodies.iter().zip(frames.as_slice());
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

    pub(crate) fn with_markers(
        mut self,
        points: &Points<Vector3<T>, N>,
    ) -> Result<Self, GeometryError> {
        parts::finite(self.points_of(points))?;
        self.markers = self.markers_at(points)?;
        Ok(self)
    }

    /// The model with `size` brought up to date.
    pub(crate) fn sized(self) -> Self {
        let forms = self.forms();
        let distances = forms.distances.all(self.distances.as_slice().iter());
        let lines = forms.lines.all(self.lines.as_slice().iter());
        let planes = forms.planes.all(self.planes.as_slice().iter());
        let stretches = forms.stretches.all(self.stretches.as_slice().iter());
        let lengths = distances
            .map(|(_, distance)| distance.length())
            .chain(lines.map(|(_, line)| line.length()))
            .chain(planes.map(|(_, plane)| plane.length()))
            .chain(stretches.map(|(_, stretch)| stretch.length()));
        let size = lengths.fold(T::zero(), |longest, length| longest.max(length));
        Self { size, ..self }
    }
}

/// A table of results, filled up to the first error.
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
