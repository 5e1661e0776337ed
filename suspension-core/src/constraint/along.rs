//! A point on a line.

use nalgebra::Vector3;

use crate::scalar::Scalar;
use crate::vector::{difference, dot, minus_multiple, multiple, plus_multiple};

/// A point `p` on the line from `o` to `h`, which are a constant length `L` apart:
/// `F = p - o - s e / L`, with `e = h - o` and an unknown `s`, the distance from `o` to `p` along the line.
///
/// One unknown and three equations: regular wherever the line points, and where `p` is one of its ends.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Along<T> {
    length: T,
    inverse: T,
}

/// Derivatives of an [`Along`] equation. By the points they are multiples of the identity; by `p` it is 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AlongGradient<T> {
    /// `dF/do`.
    pub from: T,
    /// `dF/dh`.
    pub to: T,
    /// `dF/ds`.
    pub distance: Vector3<T>,
}

impl<T: Scalar> Along<T> {
    /// A line whose ends are `length` apart, which must not be zero.
    #[inline]
    pub fn new(length: T) -> Self {
        Self {
            length,
            inverse: T::one() / length,
        }
    }

    /// The length `L` between the ends of the line.
    #[inline]
    pub fn length(&self) -> T {
        self.length
    }

    /// The distance `s` at which the line comes nearest to the point.
    #[inline]
    pub fn distance(&self, point: Vector3<T>, [from, to]: [Vector3<T>; 2]) -> T {
        dot(difference(point, from), difference(to, from)) * self.inverse
    }

    /// `F(p, o, h, s)`, from the line to the point.
    #[inline(always)]
    pub fn residual(
        &self,
        point: Vector3<T>,
        [from, to]: [Vector3<T>; 2],
        distance: T,
    ) -> Vector3<T> {
        let share = distance * self.inverse;
        minus_multiple(difference(point, from), difference(to, from), share)
    }

    /// The derivatives by the ends of the line and by `s`.
    #[inline(always)]
    pub fn gradient(&self, [from, to]: [Vector3<T>; 2], distance: T) -> AlongGradient<T> {
        let share = distance * self.inverse;
        AlongGradient {
            from: share - T::one(),
            to: -share,
            distance: multiple(difference(to, from), -self.inverse),
        }
    }

    /// `C(v, w)`, with the changes of `e` and of `s` in each.
    #[inline(always)]
    pub fn curvature(&self, v: (Vector3<T>, T), w: (Vector3<T>, T)) -> Vector3<T> {
        let bent = plus_multiple(multiple(v.0, w.1), w.0, v.1);
        multiple(bent, -self.inverse)
    }

    /// The same in other numbers: see [`Listing::gather`](crate::linkage::Listing::gather).
    #[inline(always)]
    pub fn gather<M, S: Scalar>(
        of: impl Fn(&M) -> Along<S>,
        number: &impl Fn(&dyn Fn(&M) -> S) -> T,
    ) -> Self {
        // The inverse to all digits of the other number: it is part of the equation.
        Self::new(number(&|model| of(model).length))
    }
}
