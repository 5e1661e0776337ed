//! The geometry of a listing.

use nalgebra::Vector3;
use suspension_core::Scalar;
use suspension_core::constraint::{
    Bilinear, Carried, Distance, Frame, Held, InPlane, OnLine, Product, Stretch, Turn,
};
use suspension_core::generated::gather_vector;
use suspension_core::handedness::Linked;
use suspension_core::listing::{DriveKind, Kind, MeasureKind, Part, Parts, WheelPlaces};

use crate::fitted::Fitted;
use crate::plan::Plan;
use crate::size::{Few, Room, Size};
use crate::table::{Table, Value};

/// The geometry of a listing: chassis points at rest and the constants of every equation.
#[derive(Clone, Copy, Debug)]
pub struct Model<'l, T: Scalar, const N: usize>
where
    Room<N>: Size,
{
    pub(crate) listing: Fitted<'l, N>,
    pub(crate) fixed: Few<Vector3<T>, N>,
    pub(crate) size: T,
    pub(crate) distances: [Distance<T>; N],
    /// Of all bodies.
    pub(crate) frames: Few<Frame<T>, N>,
    /// Of the points that all bodies carry.
    pub(crate) carried: Few<Carried<T>, N>,
    /// Of the lines that points slide on.
    pub(crate) lines: Few<OnLine<T>, N>,
    /// Of the planes that points stay in.
    pub(crate) planes: Few<InPlane<T>, N>,
    /// Of the lengths that drives prescribe.
    pub(crate) stretches: Few<Stretch<T>, N>,
    /// Of the angles between lines that stay as they are.
    pub(crate) products: Few<Product<T>, N>,
    /// Of the angles about axes that drives prescribe.
    pub(crate) turns: Few<Turn<T>, N>,
    /// Of the lengths that sums of products are over.
    pub(crate) scales: Few<Bilinear<T>, N>,
    /// Of the sums of coordinates that stay as they are.
    pub(crate) held: Few<Held<T>, N>,
    pub(crate) markers: Few<Carried<T>, N>,
    pub(crate) cluster_frames: Few<Frame<T>, N>,
    /// Of the points of all clusters beside their frames.
    pub(crate) linked: Few<Linked<T>, N>,
}

impl<'l, T: Scalar, const N: usize> Model<'l, T, N>
where
    Room<N>: Size,
{
    #[inline(always)]
    pub(crate) fn plan(&self) -> &'l Plan {
        self.listing.plan()
    }

    /// See [`gather`](suspension_core::linkage::Listing::gather).
    pub(crate) fn gather<S: Scalar>(
        listing: Fitted<'l, N>,
        number: impl Fn(&dyn Fn(&Model<'l, S, N>) -> S) -> T,
    ) -> Self {
        let number = &number;
        let plan = listing.plan();
        let distance = |index| {
            if index >= plan.distances.len() {
                return Distance::default();
            }
            let of = |model: &Model<'l, S, N>| model.distances.get(index).copied();
            Distance::gather(|model| of(model).unwrap_or_default(), number)
        };
        let (bodies, clusters) = (plan.bodies.len(), plan.clusters.len());
        let linked = plan.clusters.iter().map(|cluster| cluster.points.len());
        Self {
            listing,
            fixed: first(plan.chassis.into(), |at| {
                gather_vector(|model| model.fixed.get(at), number)
            }),
            size: number(&|model| model.size),
            distances: core::array::from_fn(distance),
            frames: first(bodies, |at| {
                Frame::gather(|model| model.frames.get(at), number)
            }),
            carried: first(plan.carried(), |at| {
                Carried::gather(|model| model.carried.get(at), number)
            }),
            lines: first(plan.lines.len(), |at| {
                OnLine::gather(|model| model.lines.get(at), number)
            }),
            planes: first(plan.planes.len(), |at| {
                InPlane::gather(|model| model.planes.get(at), number)
            }),
            stretches: first(plan.stretches.len(), |at| {
                Stretch::gather(|model| model.stretches.get(at), number)
            }),
            products: first(plan.products.len(), |at| {
                Product::gather(|model| model.products.get(at), number)
            }),
            turns: first(plan.turns.len(), |at| {
                Turn::gather(|model| model.turns.get(at), number)
            }),
            scales: first(plan.scales.len(), |at| {
                Bilinear::gather(|model| model.scales.get(at), number)
            }),
            held: first(plan.held().count(), |at| {
                Held::gather(|model| model.held.get(at), number)
            }),
            markers: first(plan.markers.len(), |at| {
                Carried::gather(|model| model.markers.get(at), number)
            }),
            cluster_frames: first(clusters, |at| {
                Frame::gather(|model| model.cluster_frames.get(at), number)
            }),
            linked: first(linked.sum(), |at| {
                Linked::gather(|model| model.linked.get(at), number)
            }),
        }
    }
}

/// A table of what is made for each of its first places.
fn first<V: Value, F: Table<V>>(count: usize, make: impl Fn(u16) -> V) -> F {
    F::from_values((0..).take(count).map(make))
}

impl<T: Scalar, const N: usize> Parts for Model<'_, T, N>
where
    Room<N>: Size,
{
    fn name(&self, part: Part) -> &str {
        self.listing.name(part)
    }

    #[inline(always)]
    fn count(&self, kind: Kind) -> usize {
        self.listing.count(kind)
    }

    fn drive_kind(&self, drive: usize) -> DriveKind {
        self.listing.drive_kind(drive)
    }

    fn measure_kind(&self, measure: usize) -> MeasureKind {
        self.listing.measure_kind(measure)
    }

    fn wheel(&self, wheel: usize) -> Option<WheelPlaces<'_>> {
        self.listing.wheel(wheel)
    }
}
