//! The geometry of a listing.

use nalgebra::Vector3;
use suspension_core::Scalar;
use suspension_core::constraint::{Carried, Distance, Frame};
use suspension_core::handedness::Linked;

use crate::listing::Listing;
use crate::size::{Room, Size};

/// The room of a model.
pub(crate) type Few<V, const N: usize> = <Room<N> as Size>::Few<V>;

/// The geometry of a listing: chassis points at rest and the constants of every equation.
#[derive(Clone, Copy, Debug)]
pub struct Model<'l, T: Scalar, const N: usize>
where
    Room<N>: Size,
{
    pub(crate) listing: &'l Listing,
    pub(crate) fixed: Few<Vector3<T>, N>,
    pub(crate) size: T,
    pub(crate) distances: [Distance<T>; N],
    pub(crate) frames: Few<Frame<T>, N>,
    /// Of all bodies, one after the other.
    pub(crate) carried: Few<Carried<T>, N>,
    pub(crate) markers: Few<Carried<T>, N>,
    pub(crate) cluster_frames: Few<Frame<T>, N>,
    pub(crate) linked: Few<Linked<T>, N>,
}
