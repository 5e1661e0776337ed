//! The kinds of equation: each with its residual, gradient and curvature side by side.
//!
//! Every kind is at most quadratic in the coordinates, so its second derivative is a constant
//! bilinear form `C(v, w)` and
//!
//! ```text
//! F(q + d) = F(q) + J(q) d + C(d, d) / 2        exactly.
//! ```
//!
//! Residuals are in units of length. Generated code calls these functions; no derivative is
//! written anywhere else.

use nalgebra::{Matrix3, Vector3};

use crate::scalar::{Real, Scalar};
use crate::signal::Signal;
use crate::trigonometry::sine_cosine;
use crate::vector::{
    cross, difference, dot, gather_vectors, minus_multiple, multiple, opposite, plus_cross,
    plus_multiple,
};

/// A constant length `L` between two points, with `d` the vector from one to the other:
/// `F = (|d|^2 - L^2) / (2 L)`. Attia 2003, eq. (1.1) to (1.14), divided by `2 L`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distance<T> {
    length: T,
    inverse: T,
}

impl<T: Scalar> Distance<T> {
    /// A distance of `length`, which must not be zero.
    #[inline]
    pub fn new(length: T) -> Self {
        Self {
            length,
            inverse: T::one() / length,
        }
    }

    /// The length `L`.
    #[inline]
    pub fn length(&self) -> T {
        self.length
    }

    /// `F(d)`: to first order the amount by which `d` is too long.
    #[inline(always)]
    pub fn residual(&self, d: Vector3<T>) -> T {
        // The gradient is at hand wherever the equation is solved.
        (dot(d, self.gradient(d)) - self.length) * T::constant(0.5)
    }

    /// `dF/dd = d / L`.
    #[inline(always)]
    pub fn gradient(&self, d: Vector3<T>) -> Vector3<T> {
        multiple(d, self.inverse)
    }

    /// `C(v, w) = v . w / L`, with `v` and `w` changes of `d`.
    #[inline(always)]
    pub fn curvature(&self, v: Vector3<T>, w: Vector3<T>) -> T {
        dot(v, w) * self.inverse
    }

    /// The same of other numbers.
    #[inline(always)]
    pub fn gather<S: Scalar, const K: usize>(
        distances: [Distance<S>; K],
        gather: &impl Fn([S; K]) -> T,
    ) -> Self {
        // The inverse to all digits of the other number: it is part of the equation.
        Self::new(gather(distances.map(|distance| distance.length)))
    }
}

/// Three points of a body that do not lie in line: an origin and two edges `u`, `v` from it.
///
/// The map from points to frame is linear, so rates of three points form a frame of rates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<T> {
    /// The first point.
    pub origin: Vector3<T>,
    /// From the first point to the second.
    pub u: Vector3<T>,
    /// From the first point to the third.
    pub v: Vector3<T>,
}

impl<T: Scalar> Frame<T> {
    /// The frame of three points, or of their rates.
    #[inline(always)]
    pub fn new(origin: Vector3<T>, second: Vector3<T>, third: Vector3<T>) -> Self {
        Self {
            origin,
            u: difference(second, origin),
            v: difference(third, origin),
        }
    }

    /// The same of other numbers.
    #[inline(always)]
    pub fn gather<S: Scalar, const K: usize>(
        frames: [Frame<S>; K],
        gather: &impl Fn([S; K]) -> T,
    ) -> Self {
        Self {
            origin: gather_vectors(frames.map(|frame| frame.origin), gather),
            u: gather_vectors(frames.map(|frame| frame.u), gather),
            v: gather_vectors(frames.map(|frame| frame.v), gather),
        }
    }

    /// The three points.
    pub fn points(&self) -> [Vector3<T>; 3] {
        [self.origin, self.origin + self.u, self.origin + self.v]
    }
}

impl<T: Real> Frame<T> {
    /// A frame at rest with the given distances first-second, first-third and second-third;
    /// `None` where they break the triangle inequality.
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

    /// `u x v`, or `None` where the three points lie in line to rounding.
    pub fn normal(&self) -> Option<Vector3<T>> {
        let normal = self.u.cross(&self.v);
        let flat = T::EPSILON.sqrt() * self.u.norm() * self.v.norm();
        (normal.norm() > flat).then_some(normal)
    }
}

/// A point `p` of a rigid body, carried by the body's frame: `F = p - (o + a u + b v + c u x v)`.
///
/// Unlike three distances to the frame's points this admits no mirror image of the point and
/// stays regular where it lies in the frame's plane (`c = 0`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carried<T> {
    a: T,
    b: T,
    c: T,
}

/// Jacobian blocks of a [`Carried`] equation with respect to the frame's three points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarriedGradient<T> {
    /// `dF/d` first point of the frame.
    pub origin: Matrix3<T>,
    /// `dF/d` second point of the frame.
    pub second: Matrix3<T>,
    /// `dF/d` third point of the frame.
    pub third: Matrix3<T>,
}

impl<T: Scalar> Carried<T> {
    /// `origin + a u + b v + c normal`.
    #[inline(always)]
    fn combine(&self, frame: &Frame<T>, normal: Vector3<T>) -> Vector3<T> {
        let in_plane = plus_multiple(
            plus_multiple(frame.origin, frame.u, self.a),
            frame.v,
            self.b,
        );
        plus_multiple(in_plane, normal, self.c)
    }

    /// Where the frame carries the point.
    #[inline(always)]
    pub fn position(&self, frame: &Frame<T>) -> Vector3<T> {
        self.combine(frame, cross(frame.u, frame.v))
    }

    /// The point's velocity, from the frame and its rates.
    #[inline(always)]
    pub fn velocity(&self, frame: &Frame<T>, rate: &Frame<T>) -> Vector3<T> {
        let normal_rate = plus_cross(cross(rate.u, frame.v), frame.u, rate.v);
        self.combine(rate, normal_rate)
    }

    /// The point's acceleration, from the frame, its rates and second rates.
    #[inline(always)]
    pub fn acceleration(&self, frame: &Frame<T>, rate: &Frame<T>, second: &Frame<T>) -> Vector3<T> {
        difference(self.velocity(frame, second), self.curvature(rate, rate))
    }

    /// `F(p)`, the distance vector from where the frame carries the point to `p`.
    #[inline(always)]
    pub fn residual(&self, point: Vector3<T>, frame: &Frame<T>) -> Vector3<T> {
        let from_origin = difference(point, frame.origin);
        let in_plane = minus_multiple(
            minus_multiple(from_origin, frame.u, self.a),
            frame.v,
            self.b,
        );
        minus_multiple(in_plane, cross(frame.u, frame.v), self.c)
    }

    /// `dF/d` of the frame's points; `dF/dp` is the identity.
    #[inline(always)]
    pub fn gradient(&self, frame: &Frame<T>) -> CarriedGradient<T> {
        let (of_second, of_third) = (multiple(frame.v, self.c), multiple(frame.u, self.c));
        // The blocks of all four points add up to zero: a translation changes nothing.
        CarriedGradient {
            origin: skew_minus(difference(of_third, of_second), T::one() - self.a - self.b),
            second: skew_minus(of_second, self.a),
            third: skew_minus(opposite(of_third), self.b),
        }
    }

    /// What a gradient by the point is by the frame's three points, the point being where the frame
    /// carries it: the transpose of [`velocity`](Self::velocity).
    #[inline(always)]
    pub fn by_frame(&self, gradient: Vector3<T>, frame: &Frame<T>) -> [Vector3<T>; 3] {
        let (u, v) = (multiple(frame.u, self.c), multiple(frame.v, self.c));
        let by_second = plus_cross(multiple(gradient, self.a), v, gradient);
        let by_third = plus_cross(multiple(gradient, self.b), gradient, u);
        let by_origin = difference(difference(gradient, by_second), by_third);
        [by_origin, by_second, by_third]
    }

    /// `C(v, w)`, with `v` and `w` frames of rates. The point itself enters linearly.
    #[inline(always)]
    pub fn curvature(&self, v: &Frame<T>, w: &Frame<T>) -> Vector3<T> {
        multiple(plus_cross(cross(v.u, w.v), w.u, v.v), -self.c)
    }

    /// The same of other numbers.
    #[inline(always)]
    pub fn gather<S: Scalar, const K: usize>(
        carried: [Carried<S>; K],
        gather: &impl Fn([S; K]) -> T,
    ) -> Self {
        Self {
            a: gather(carried.map(|carried| carried.a)),
            b: gather(carried.map(|carried| carried.b)),
            c: gather(carried.map(|carried| carried.c)),
        }
    }
}

impl<T: Real> Carried<T> {
    /// The constants of `point` as it stands in `frame`; `None` where the frame is in line.
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

    /// The constants of a point at the given distances from the frame's three points, on the
    /// side of the frame on which `self` lies; `None` where no point has these distances. A point
    /// nearer to the frame's plane than rounding can tell is put into it.
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
        // What cancellation leaves of a height of zero.
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
#[inline(always)]
fn skew_minus<T: Scalar>(w: Vector3<T>, k: T) -> Matrix3<T> {
    #[rustfmt::skip]
    let matrix = Matrix3::new(
          -k, -w.z,  w.y,
         w.z,   -k, -w.x,
        -w.y,  w.x,   -k,
    );
    matrix
}

/// The coordinate that a driving angle prescribes: `h = L cos(theta)` and its rates by the
/// chain rule. The angle stays outside the algebra (Attia 2003, eq. 1.15).
#[inline(always)]
pub fn angle_to_coordinate<T: Scalar>(length: T, angle: Signal<T>) -> Signal<T> {
    let (sine, cosine) = sine_cosine(angle.value);
    Signal {
        value: length * cosine,
        rate: -length * sine * angle.rate,
        second_rate: -length * (cosine * angle.rate * angle.rate + sine * angle.second_rate),
    }
}
