//! Three points that carry others.

use nalgebra::Vector3;

use crate::arithmetic::scalar::{Real, Scalar};
use crate::arithmetic::vector::{difference, gather_vector};

/// Three points of a body that are not collinear: an origin and two edges `u`, `v` from it.
///
/// The map from points to frame is linear, so rates of three points form a frame of rates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<T> {
    /// The first point.
    pub origin: Vector3<T>,
    /// The edge from the first point to the second.
    pub u: Vector3<T>,
    /// The edge from the first point to the third.
    pub v: Vector3<T>,
}

impl<T: Scalar> Frame<T> {
    /// The frame of three points, or of their rates.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn new(origin: Vector3<T>, second: Vector3<T>, third: Vector3<T>) -> Self {
        Self {
            origin,
            u: difference(second, origin),
            v: difference(third, origin),
        }
    }

    /// The same frame in another number type: see [`Listing::gather`](crate::linkage::Listing::gather).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gather<M, S: Scalar>(
        of: impl Fn(&M) -> Frame<S>,
        number: &impl Fn(&dyn Fn(&M) -> S) -> T,
    ) -> Self {
        Self {
            origin: gather_vector(|model| of(model).origin, number),
            u: gather_vector(|model| of(model).u, number),
            v: gather_vector(|model| of(model).v, number),
        }
    }

    /// The three points.
    pub fn points(&self) -> [Vector3<T>; 3] {
        [self.origin, self.origin + self.u, self.origin + self.v]
    }
}

impl<T: Scalar> Default for Frame<T> {
    fn default() -> Self {
        let [origin, u, v] = [(); 3].map(|()| Vector3::default());
        Self { origin, u, v }
    }
}

impl<T: Real> Frame<T> {
    /// A frame at rest with the given distances first-second, first-third and second-third; `None` if they break the
    /// triangle inequality.
    pub fn from_lengths(first_second: T, first_third: T, second_third: T) -> Option<Self> {
        let (a, b, c) = (first_second, first_third, second_third);
        let along = (a * a + b * b - c * c) / (a + a);
        let across = (b - along) * (b + along);
        (across > T::zero()).then(|| Self {
            origin: Vector3::zeros(),
            u: Vector3::new(a, T::zero(), T::zero()),
            v: Vector3::new(along, across.sqrt(), T::zero()),
        })
    }

    /// The distances first-second, first-third and second-third.
    pub fn lengths(&self) -> [T; 3] {
        [self.u, self.v, self.v - self.u].map(|edge| edge.norm())
    }

    /// `u x v`, or `None` if the three points are collinear to rounding.
    pub fn normal(&self) -> Option<Vector3<T>> {
        let normal = self.u.cross(&self.v);
        let flat = T::EPSILON.sqrt() * self.u.norm() * self.v.norm();
        (normal.norm() > flat).then_some(normal)
    }
}
