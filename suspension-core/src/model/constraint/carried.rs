//! A point of a rigid body.

use nalgebra::{Matrix3, Vector3};

use super::Frame;
use crate::arithmetic::scalar::{Real, Scalar};
use crate::arithmetic::vector::{
    cross, difference, minus_multiple, multiple, opposite, plus_cross, plus_multiple, sum,
};

/// A point `p` of a rigid body, carried by the body's frame: `F = p - (o + a u + b v + c u x v)`.
///
/// Unlike three distances to the frame's points, this admits no mirror image of the point and stays regular if the
/// point lies in the frame's plane (`c = 0`).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Carried<T> {
    a: T,
    b: T,
    c: T,
}

/// Jacobian blocks of a [`Carried`] equation with respect to the frame's three points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarriedGradient<T> {
    /// The derivative with respect to the first point of the frame.
    pub origin: Matrix3<T>,
    /// The derivative with respect to the second point of the frame.
    pub second: Matrix3<T>,
    /// The derivative with respect to the third point of the frame.
    pub third: Matrix3<T>,
}

impl<T: Scalar> Carried<T> {
    /// `origin + a u + b v + c normal`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn combine(&self, frame: &Frame<T>, normal: Vector3<T>) -> Vector3<T> {
        let in_plane = plus_multiple(
            plus_multiple(frame.origin, frame.u, self.a),
            frame.v,
            self.b,
        );
        plus_multiple(in_plane, normal, self.c)
    }

    /// The position to which the frame carries the point.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn position(&self, frame: &Frame<T>) -> Vector3<T> {
        self.combine(frame, cross(frame.u, frame.v))
    }

    /// The velocity of the carried point, from the frame and its rates.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn velocity(&self, frame: &Frame<T>, rate: &Frame<T>) -> Vector3<T> {
        let normal_rate = plus_cross(cross(rate.u, frame.v), frame.u, rate.v);
        self.combine(rate, normal_rate)
    }

    /// The acceleration of the carried point, from the frame, its rates and second rates.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn acceleration(&self, frame: &Frame<T>, rate: &Frame<T>, second: &Frame<T>) -> Vector3<T> {
        difference(self.velocity(frame, second), self.curvature(rate, rate))
    }

    /// `F(p)`: the vector to `p` from the position to which the frame carries the point.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn residual(&self, point: Vector3<T>, frame: &Frame<T>) -> Vector3<T> {
        let from_origin = difference(point, frame.origin);
        let in_plane = minus_multiple(
            minus_multiple(from_origin, frame.u, self.a),
            frame.v,
            self.b,
        );
        minus_multiple(in_plane, cross(frame.u, frame.v), self.c)
    }

    /// The derivatives of `F` with respect to the frame's points; `dF/dp` is the identity.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gradient(&self, frame: &Frame<T>) -> CarriedGradient<T> {
        let (of_second, of_third) = (multiple(frame.v, self.c), multiple(frame.u, self.c));
        // The blocks of all four points add up to zero, because a translation changes nothing.
        CarriedGradient {
            origin: skew_minus(difference(of_third, of_second), T::one() - self.a - self.b),
            second: skew_minus(of_second, self.a),
            third: skew_minus(opposite(of_third), self.b),
        }
    }

    /// The gradient with respect to the frame's three points, from the gradient with respect to the carried point:
    /// the transpose of [`velocity`](Self::velocity).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn by_frame(&self, gradient: Vector3<T>, frame: &Frame<T>) -> [Vector3<T>; 3] {
        let (u, v) = (multiple(frame.u, self.c), multiple(frame.v, self.c));
        let by_second = plus_cross(multiple(gradient, self.a), v, gradient);
        let by_third = plus_cross(multiple(gradient, self.b), gradient, u);
        let by_origin = difference(difference(gradient, by_second), by_third);
        [by_origin, by_second, by_third]
    }

    /// Adds a force at the carried point to the forces at the frame's three points, so that these do its work too.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn carry_force(&self, force: Vector3<T>, frame: &Frame<T>, at_frame: [&mut Vector3<T>; 3]) {
        for (at, part) in at_frame.into_iter().zip(self.by_frame(force, frame)) {
            *at = sum(*at, part);
        }
    }

    /// `C(v, w)`, where `v` and `w` are frames of rates. The point itself enters linearly.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn curvature(&self, v: &Frame<T>, w: &Frame<T>) -> Vector3<T> {
        multiple(plus_cross(cross(v.u, w.v), w.u, v.v), -self.c)
    }

    /// The same constraint in another number type: see [`Listing::gather`](crate::linkage::Listing::gather).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gather<M, S: Scalar>(
        of: impl Fn(&M) -> Carried<S>,
        number: &impl Fn(&dyn Fn(&M) -> S) -> T,
    ) -> Self {
        Self {
            a: number(&|model| of(model).a),
            b: number(&|model| of(model).b),
            c: number(&|model| of(model).c),
        }
    }
}

impl<T: Real> Carried<T> {
    /// The constants of `point` at its present position in `frame`; `None` if the frame's points are collinear.
    pub fn new(point: Vector3<T>, frame: &Frame<T>) -> Option<Self> {
        let normal = frame.normal()?;
        let area_squared = normal.norm_squared();
        let d = point - frame.origin;
        Some(Self {
            a: d.cross(&frame.v).dot(&normal) / area_squared,
            b: frame.u.cross(&d).dot(&normal) / area_squared,
            c: d.dot(&normal) / area_squared,
        })
    }

    /// The distances from the point to the three points of its frame.
    pub fn lengths(&self, frame: &Frame<T>) -> [T; 3] {
        let point = self.position(frame);
        frame.points().map(|of_frame| (point - of_frame).norm())
    }

    /// The constants of a point at the given distances from the frame's three points, on the same side of the frame
    /// as `self`; `None` if no point has these distances. A point that is nearer to the frame's plane than rounding
    /// can tell is put into the plane.
    pub fn with_lengths(&self, frame: &Frame<T>, lengths: [T; 3]) -> Option<Self> {
        let [from_origin, from_second, from_third] = lengths;
        let (uu, uv, vv) = (
            frame.u.dot(&frame.u),
            frame.u.dot(&frame.v),
            frame.v.dot(&frame.v),
        );
        let half = T::constant(0.5);
        let reach = from_origin * from_origin;
        let along_u = (reach - from_second * from_second + uu) * half;
        let along_v = (reach - from_third * from_third + vv) * half;
        let area_squared = frame.normal()?.norm_squared();
        let a = (along_u * vv - along_v * uv) / area_squared;
        let b = (along_v * uu - along_u * uv) / area_squared;
        let in_plane = frame.u * a + frame.v * b;
        let height_squared = reach - in_plane.norm_squared();
        // The error that cancellation leaves in a height of zero.
        let flatness = uu * vv / area_squared;
        let rounding = reach * flatness * T::EPSILON * T::constant(64.0);
        if height_squared < -rounding {
            return None;
        }
        let is_flat = height_squared <= rounding;
        let c = if is_flat {
            T::zero()
        } else {
            (height_squared / area_squared).sqrt()
        };
        Some(Self {
            a,
            b,
            c: if self.c < T::zero() { -c } else { c },
        })
    }
}

/// `[w x] - k I`.
#[cfg_attr(not(debug_assertions), inline(always))]
fn skew_minus<T: Scalar>(w: Vector3<T>, k: T) -> Matrix3<T> {
    #[rustfmt::skip]
    let matrix = Matrix3::new(
          -k, -w.z,  w.y,
         w.z,   -k, -w.x,
        -w.y,  w.x,   -k,
    );
    matrix
}
