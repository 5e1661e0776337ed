//! The geometry of a listing.

use nalgebra::Vector3;
use suspension_core::constraint::{Along, Carried, Distance, Frame};
use suspension_core::generated::gather_vectors;
use suspension_core::handedness::Linked;
use suspension_core::{DriveKind, Kind, MeasureKind, Part, Parts, Scalar};

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
    pub(crate) along: Few<Along<T>, N>,
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

    /// A model whose numbers are each made of the same number of each of `models`.
    pub(crate) fn gather<S: Scalar, const K: usize>(
        models: [&Model<'l, S, N>; K],
        gather: impl Fn([S; K]) -> T,
    ) -> Self {
        const { assert!(K > 0, "a model is made of one or more") }
        #[allow(clippy::indexing_slicing, reason = "there is a first")]
        let first = models[0];
        let vector = |vectors| gather_vectors(vectors, &gather);
        Self {
            listing: first.listing,
            fixed: each(models.map(|model| &model.fixed), vector),
            size: gather(models.map(|model| model.size)),
            distances: core::array::from_fn(|index| {
                let distances = models.map(|model| model.distances.get(index).copied());
                Distance::gather(distances.map(Option::unwrap_or_default), &gather)
            }),
            frames: each(models.map(|model| &model.frames), |frames| {
                Frame::gather(frames, &gather)
            }),
            carried: each(models.map(|model| &model.carried), |carried| {
                Carried::gather(carried, &gather)
            }),
            along: each(models.map(|model| &model.along), |lines| {
                Along::gather(lines, &gather)
            }),
            markers: each(models.map(|model| &model.markers), |markers| {
                Carried::gather(markers, &gather)
            }),
            cluster_frames: each(models.map(|model| &model.cluster_frames), |frames| {
                Frame::gather(frames, &gather)
            }),
            linked: each(models.map(|model| &model.linked), |linked| {
                Linked::gather(linked, &gather)
            }),
        }
    }
}

/// A table of what is made of each place of others.
fn each<V: Value, W: Value, F: Table<V>, G: Table<W>, const K: usize>(
    tables: [&F; K],
    make: impl Fn([V; K]) -> W,
) -> G {
    let places = (0..).take(G::ROOM);
    G::from_values(places.map(|place| make(tables.map(|table| table.get(place)))))
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
}
