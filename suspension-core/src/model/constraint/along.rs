//! A point at distances along lines from one point: on a line, or in a plane.

use nalgebra::Vector3;

use crate::arithmetic::scalar::{Real, Scalar};
use crate::arithmetic::vector::{
    cross, difference, dot, minus_multiple, multiple, opposite, plus_multiple,
};

/// A point `p` at distances `s_k` from `o` along `K` lines to `h_k`: `F = p - o - sum s_k e_k / L_k`. Here
/// `e_k = h_k - o`, `L_k` is its length in the design, and the `s_k` are unknowns. With one line the point is on it;
/// with two it is in their plane.
///
/// `K` unknowns and three equations: regular for any directions of the lines, and also if `p` is one of their ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Along<T, const K: usize> {
    lengths: [T; K],
    inverses: [T; K],
}

/// A point on a line.
pub type OnLine<T> = Along<T, 1>;

/// A point in a plane.
pub type InPlane<T> = Along<T, 2>;

/// Derivatives of an [`Along`] equation. Those with respect to points are multiples of the identity; with respect to
/// `p` it is 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AlongGradient<T, const K: usize> {
    /// `dF/do`.
    pub from: T,
    /// `dF/dh_k` and `dF/ds_k`.
    pub lines: [(T, Vector3<T>); K],
}

impl<T: Scalar, const K: usize> Along<T, K> {
    /// Lines of these lengths, which must not be zero.
    #[inline]
    pub fn new(lengths: [T; K]) -> Self {
        Self {
            lengths,
            inverses: lengths.map(|length| T::one() / length),
        }
    }

    /// `F(p, o, h, s)`: the vector from the line or plane to the point. Each end is paired with its distance.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn residual(
        &self,
        point: Vector3<T>,
        from: Vector3<T>,
        ends: [(Vector3<T>, T); K],
    ) -> Vector3<T> {
        let lines = ends.into_iter().zip(self.inverses);
        lines.fold(difference(point, from), |off, ((to, distance), inverse)| {
            minus_multiple(off, difference(to, from), distance * inverse)
        })
    }

    /// The derivatives with respect to `o`, to the ends of the lines and to the distances.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gradient(&self, from: Vector3<T>, ends: [(Vector3<T>, T); K]) -> AlongGradient<T, K> {
        let mut gradient = AlongGradient {
            from: -T::one(),
            lines: [(T::zero(), Vector3::zeros()); K],
        };
        let lines = ends.into_iter().zip(self.inverses);
        for (place, ((to, distance), inverse)) in gradient.lines.iter_mut().zip(lines) {
            let share = distance * inverse;
            gradient.from += share;
            *place = (-share, multiple(difference(to, from), -inverse));
        }
        gradient
    }

    /// `C(v, w)`, where `v` and `w` each hold the changes of every `e_k` and `s_k`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn curvature(&self, v: [(Vector3<T>, T); K], w: [(Vector3<T>, T); K]) -> Vector3<T> {
        let lines = v.into_iter().zip(w).zip(self.inverses);
        // Adding to a negative zero leaves the other number as it is, a negative zero included.
        let zero = opposite(Vector3::zeros());
        lines.fold(zero, |sum, ((v, w), inverse)| {
            let bent = plus_multiple(multiple(v.0, w.1), w.0, v.1);
            minus_multiple(sum, bent, inverse)
        })
    }

    /// The same constraint in another number type: see [`Listing::gather`](crate::linkage::Listing::gather).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gather<M, S: Scalar>(
        of: impl Fn(&M) -> Along<S, K>,
        number: &impl Fn(&dyn Fn(&M) -> S) -> T,
    ) -> Self {
        // The inverses have all digits of the other number type, because they are part of the equation.
        let length = |model: &M, line| of(model).lengths.get(line).copied().unwrap_or_default();
        Self::new(core::array::from_fn(|line| {
            number(&|model| length(model, line))
        }))
    }
}

impl<T: Scalar> OnLine<T> {
    /// The distance along the line at which it is nearest to the point.
    #[inline]
    pub fn distances(&self, point: Vector3<T>, from: Vector3<T>, [to]: [Vector3<T>; 1]) -> [T; 1] {
        let d = difference(point, from);
        self.inverses
            .map(|inverse| dot(d, difference(to, from)) * inverse)
    }
}

impl<T: Scalar> InPlane<T> {
    /// The distances along the two lines at which their plane is nearest to the point.
    #[inline]
    pub fn distances(&self, point: Vector3<T>, from: Vector3<T>, ends: [Vector3<T>; 2]) -> [T; 2] {
        let (d, [u, v]) = (difference(point, from), ends.map(|to| difference(to, from)));
        let normal = cross(u, v);
        let per_area = multiple(normal, T::one() / dot(normal, normal));
        let [of_u, of_v] = self.lengths;
        [
            dot(cross(d, v), per_area) * of_u,
            dot(cross(u, d), per_area) * of_v,
        ]
    }
}

impl<T: Real, const K: usize> Along<T, K> {
    /// The longest of the lengths.
    #[inline]
    pub fn length(&self) -> T {
        let lengths = self.lengths.into_iter();
        lengths.fold(T::zero(), |longest, length| longest.max(length))
    }
}

impl<T: Scalar, const K: usize> Default for Along<T, K> {
    fn default() -> Self {
        let [lengths, inverses] = [[T::zero(); K]; 2];
        Self { lengths, inverses }
    }
}
