//! Constant lengths, written to the model and read from it.

use nalgebra::Vector3;
use suspension_core::model::constraint::{Bilinear, Carried, Distance, Frame, OnLine, Product};
use suspension_core::model::handedness::Linked;
use suspension_core::{GeometryError, Real, Values, model::parts};

use crate::build::fill;
use crate::model::Model;
use crate::plan::{BodyPoint, Length, LineLength};
use crate::site::Site;
use crate::size::{Few, Lengths, Room, Size};
use crate::table::Table;

/// Lengths, and the bodies that have them.
struct Shaped<'a, T: Real, const N: usize>
where
    Room<N>: Size,
{
    lengths: &'a Lengths<T, N>,
    frames: &'a Few<Frame<T>, N>,
    carried: &'a Few<Carried<T>, N>,
}

impl<T: Real, const N: usize> Model<'_, T, N>
where
    Room<N>: Size,
{
    pub(crate) fn lengths(&self) -> Lengths<T, N> {
        let of = |lengths: [T; 3], index| lengths.get(usize::from(index)).copied();
        let value = |length: &Length| match *length {
            Length::Distance(distance) => Some(self.distances.get(distance).length()),
            Length::Edge { body, edge } => of(self.frames.get(body).lengths(), edge),
            Length::Reach {
                body,
                carried,
                corner,
            } => {
                let frame = self.frames.get(body);
                of(self.carried.get(carried).lengths(&frame), corner)
            }
        };
        let values = self.plan().lengths.iter().map(value);
        Lengths::<T, N>::from_values(values.map(Option::unwrap_or_default))
    }

    pub(crate) fn with_lengths(self, lengths: &Lengths<T, N>) -> Result<Self, GeometryError> {
        let plan = self.plan();
        parts::positive(lengths.values().take(plan.lengths.len()))?;
        let bodies = self.forms().bodies.iter();
        let bodies = bodies.map(|body| (body.frame, body.edges));
        let clusters = plan.clusters.iter();
        let clusters = clusters.map(|cluster| (cluster.frame, cluster.edges));
        let frames = fill(bodies.map(|(frame, edges)| self.frame_with(lengths, frame, edges)))?;
        let cluster_frames =
            fill(clusters.map(|(frame, edges)| self.frame_with(lengths, frame, edges)))?;
        let carried = self.carried_with(lengths, &frames)?;
        let distances = self.forms().distances.iter();
        let distances = distances.map(|distance| Distance::new(lengths.get(distance.length)));
        let shaped = Shaped {
            lengths,
            frames: &frames,
            carried: &carried,
        };
        let model = Self {
            distances: Values::from_values(distances),
            carried,
            lines: self.lines_with(&shaped)?,
            products: self.products_with(&shaped)?,
            scales: self.scales_with(&shaped)?,
            linked: self.linked_with(lengths, &cluster_frames)?,
            frames,
            cluster_frames,
            ..self
        };
        Ok(model.sized())
    }

    /// A frame at rest whose edges have the given lengths.
    fn frame_with(
        &self,
        lengths: &Lengths<T, N>,
        [a, b, c]: [Site; 3],
        [first, second, third]: [Option<u16>; 3],
    ) -> Result<Frame<T>, GeometryError> {
        let edges = [(first, [a, b]), (second, [a, c]), (third, [b, c])];
        let edges = edges.map(|(length, ends)| self.given_length(lengths, length, ends));
        parts::frame_of_lengths(self.point(c).into(), edges)
    }

    fn lines_with(&self, shaped: &Shaped<'_, T, N>) -> Result<Few<OnLine<T>, N>, GeometryError> {
        fill(self.forms().lines.iter().map(|line| {
            let [to] = line.ends;
            let length = self.kept(shaped, (line.length, [line.from, to]));
            parts::line(self.point(to).into(), length)
        }))
    }

    fn products_with(
        &self,
        shaped: &Shaped<'_, T, N>,
    ) -> Result<Few<Product<T>, N>, GeometryError> {
        let products = self.forms().products.iter().zip(self.products.as_slice());
        fill(products.map(|(product, now)| {
            let ([first, second], [a, b]) = (product.lengths, product.lines);
            let kept = |line| self.kept(shaped, line);
            let [_, end] = b;
            parts::product_at(
                self.point(end).into(),
                now,
                [(first, a), (second, b)].map(kept),
            )
        }))
    }

    fn scales_with(&self, shaped: &Shaped<'_, T, N>) -> Result<Few<Bilinear<T>, N>, GeometryError> {
        let scales = self.forms().scales.iter().zip(self.scales.as_slice());
        fill(
            scales.map(|(scale, now)| match (scale.kept, scale.lines.as_slice()) {
                (Some(kept), &[line]) => {
                    let [_, end] = line;
                    let length = self.kept(shaped, (kept, line));
                    parts::bilinear(self.point(end).into(), [length])
                }
                _ => Ok(*now),
            }),
        )
    }

    /// The length of a line with given lengths.
    fn kept(&self, shaped: &Shaped<'_, T, N>, (length, ends): (LineLength, [Site; 2])) -> T {
        match length {
            LineLength::Given(length) => self.given_length(shaped.lengths, length, ends),
            LineLength::Body { body, ends } => {
                let frame = shaped.frames.get(body);
                let [from, to] = ends.map(|end| match end {
                    BodyPoint::Frame(corner) => {
                        let corner = frame.points().get(usize::from(corner)).copied();
                        corner.unwrap_or_default()
                    }
                    BodyPoint::Carried(point) => shaped.carried.get(point).position(&frame),
                });
                (to - from).norm()
            }
        }
    }

    fn carried_with(
        &self,
        lengths: &Lengths<T, N>,
        frames: &Few<Frame<T>, N>,
    ) -> Result<Few<Carried<T>, N>, GeometryError> {
        let bodies = self.forms().bodies.iter().zip(frames.as_slice());
        let points = bodies.flat_map(|(body, frame)| {
            let carried = body.carried.iter();
            carried.map(move |carried| (carried, frame))
        });
        let points = points.zip(self.carried.as_slice());
        fill(points.map(|((carried, frame), now)| {
            let reaches = carried.reaches.map(|length| lengths.get(length));
            parts::carried_at(self.point(carried.point).into(), now, frame, reaches)
        }))
    }

    fn linked_with(
        &self,
        lengths: &Lengths<T, N>,
        frames: &Few<Frame<T>, N>,
    ) -> Result<Few<Linked<T>, N>, GeometryError> {
        let clusters = self.plan().clusters.iter().zip(frames.as_slice());
        let points = clusters.flat_map(|(cluster, frame)| {
            let points = cluster.points.iter();
            points.map(move |point| (point, cluster.frame, frame))
        });
        let points = points.zip(self.linked.as_slice());
        fill(points.map(|((point, corners, frame), now)| {
            let [a, b, c] = corners;
            let [first, second, third] = point.reaches;
            let reaches = [(first, a), (second, b), (third, c)];
            let reaches = reaches
                .map(|(length, corner)| self.given_length(lengths, length, [point.site, corner]));
            parts::linked_at(point.point.into(), now, frame, reaches)
        }))
    }

    /// The given length between two points or, if both are on the chassis, their present distance.
    fn given_length(&self, lengths: &Lengths<T, N>, length: Option<u16>, [a, b]: [Site; 2]) -> T {
        let at_rest = |site| match site {
            Site::Chassis(point) => self.fixed.get(point),
            Site::Free(_) => Vector3::zeros(),
        };
        match length {
            Some(length) => lengths.get(length),
            None => (at_rest(b) - at_rest(a)).norm(),
        }
    }
}
