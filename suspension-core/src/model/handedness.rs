//! The side of three points on which a fourth point lies.
//!
//! Three distances from a frame of three points do not distinguish a fourth point from its mirror image
//! in the frame's plane: a knuckle held by distances alone (Attia 2003, eq. 1.6 to 1.14) has
//! mirrored roots too. The sign of the volume `V = (p - o) . (u x v)` distinguishes them. A
//! [`Carried`] point needs no such check: its equations admit no mirror image.

use nalgebra::{SVector, Vector3};

use crate::arithmetic::scalar::{Real, Scalar};
use crate::arithmetic::vector::{cross, difference, dot};
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::listing::Part;
use crate::model::constraint::{Carried, Frame};

/// A point that only distances hold to the three points of a frame, and the side of the frame on which it stands.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Linked<T> {
    shape: Carried<T>,
    /// `1 / (2 V0)`, with `V0` the volume of the shape.
    half_inverse: T,
}

impl<T: Scalar> Linked<T> {
    /// The point as it stands in `frame`.
    #[inline]
    pub fn new(shape: Carried<T>, frame: &Frame<T>) -> Self {
        let volume = volume(shape.position(frame), frame);
        Self {
            shape,
            half_inverse: T::constant(0.5) / volume,
        }
    }

    /// The position of the point in a frame of its shape.
    #[inline]
    pub fn position(&self, frame: &Frame<T>) -> Vector3<T> {
        self.shape.position(frame)
    }

    /// Its shape with the frame.
    #[inline]
    pub fn shape(&self) -> &Carried<T> {
        &self.shape
    }

    /// `(1 - V / V0) / 2`: if the distances are kept, 0 on the point's own side of the frame and 1 on the other.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn mirrored(&self, point: Vector3<T>, frame: &Frame<T>) -> T {
        T::constant(0.5).minus_product(volume(point, frame), self.half_inverse)
    }

    /// The same point in another number type: see [`Listing::gather`](crate::linkage::Listing::gather).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gather<M, S: Scalar>(
        of: impl Fn(&M) -> Linked<S>,
        number: &impl Fn(&dyn Fn(&M) -> S) -> T,
    ) -> Self {
        Self {
            shape: Carried::gather(|model| of(model).shape, number),
            half_inverse: number(&|model| of(model).half_inverse),
        }
    }
}

/// The signed volume of the edges `u`, `v` and the line from the frame's origin to the point.
#[cfg_attr(not(debug_assertions), inline(always))]
fn volume<T: Scalar>(point: Vector3<T>, frame: &Frame<T>) -> T {
    dot(difference(point, frame.origin), cross(frame.u, frame.v))
}

/// The number of mirrored points among [`Linkage::linked`]: if the distances are kept, a whole number to rounding.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn count_mirrored<L, const N: usize>(
    linkage: &L,
    q: &SVector<L::Scalar, N>,
    fixed: &L::Fixed,
) -> L::Scalar
where
    L: Linkage<N>,
{
    let points = linkage.mirrored(q, fixed);
    points.fold(L::Scalar::constant(0.0), |count, point| count + point)
}

/// Whether no point is mirrored, according to the result of [`count_mirrored`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn is_right<T: Real>(count: T) -> bool {
    count < T::constant(0.5)
}

/// The most mirrored point of a position.
#[cold]
pub(crate) fn most_mirrored<T, L, const N: usize>(
    linkage: &L,
    q: &SVector<T, N>,
    fixed: &L::Fixed,
) -> Part
where
    T: Real,
    L: Linkage<N, Scalar = T>,
{
    let points = linkage.linked().zip(linkage.mirrored(q, fixed));
    let most = points.fold((0, T::zero()), |most, (point, mirrored)| {
        if mirrored > most.1 {
            (point, mirrored)
        } else {
            most
        }
    });
    Part::Point(most.0)
}

/// Checks that no point of a position that solves the linkage is mirrored.
///
/// # Errors
///
/// [`SolveError::Mirrored`].
pub fn check<T, L, const N: usize>(
    linkage: &L,
    q: &SVector<T, N>,
    fixed: &L::Fixed,
) -> Result<(), SolveError<T>>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
{
    if is_right(count_mirrored(linkage, q, fixed)) {
        Ok(())
    } else {
        let part = most_mirrored(linkage, q, fixed);
        Err(SolveError::Mirrored { part })
    }
}
