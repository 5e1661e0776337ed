//! An angle about an axis, by sine and cosine of its quarter.

use nalgebra::Vector3;

use crate::arithmetic::scalar::{Real, Scalar};
use crate::arithmetic::trigonometry::sine_cosine;
use crate::arithmetic::vector::{cross, dot};
use crate::model::constraint::square_root;
use crate::signal::Signal;

/// Iterations of Heron's method, which starts from the design: exact to rounding if lengths are between a hundredth
/// of those in the design and a hundred times as much.
const ROUNDS: usize = 12;

/// Sine and cosine of a quarter of an angle, times a length `L`: `F = (s^2 + c^2 - L^2) / (2 L)`.
///
/// A drive prescribes `s = L sin(theta / 4)`. The sines and cosines of the half and of the whole angle are products
/// of `s` and `c` ([`Bilinear`](super::Bilinear)). The angle is therefore regular everywhere within a whole turn in
/// either direction, including 0 and pi, where a cosine alone would be singular.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Turn<T> {
    length: T,
    inverse: T,
    /// `c / L` and `s / L` in the design.
    quarter: [T; 2],
    /// The length of the axis in the design.
    axis: T,
    /// The norm of both [`parts`](Self::parts) in the design.
    radius: T,
}

impl<T: Real> Turn<T> {
    /// The angle from `d` to `e` about `n` in the design, times a length; `None` if a line has no length, or is
    /// parallel to the axis.
    pub fn new([d, e, n]: [Vector3<T>; 3], length: T) -> Option<Self> {
        let axis = n.norm();
        let [along, across] = Self::parts([d, e, n], axis);
        let radius = (along * along + across * across).sqrt();
        let flat = T::EPSILON.sqrt() * d.norm() * e.norm() * axis;
        let (sine, cosine) = sine_cosine(T::arc_tangent(across, along) * T::constant(0.25));
        (radius > flat).then(|| Self {
            length,
            inverse: T::one() / length,
            quarter: [cosine, sine],
            axis,
            radius,
        })
    }
}

impl<T: Scalar> Turn<T> {
    /// The length `L`.
    #[inline]
    pub fn length(&self) -> T {
        self.length
    }

    /// `F(s, c)`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn residual(&self, sine: T, cosine: T) -> T {
        let square = (sine * sine).plus_product(cosine, cosine);
        (square * self.inverse - self.length) * T::constant(0.5)
    }

    /// `dF/ds = s / L`, and so `dF/dc = c / L`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gradient(&self, part: T) -> T {
        part * self.inverse
    }

    /// `C(v, w)`, where `v` and `w` each hold the changes of `s` and `c`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn curvature(&self, [v_s, v_c]: [T; 2], [w_s, w_c]: [T; 2]) -> T {
        (v_s * w_s).plus_product(v_c, w_c) * self.inverse
    }

    /// `s` and `c` of the angle from `d` to `e` about `n`, which is taken to be less than half a turn from the
    /// design's.
    #[inline]
    pub fn quarter(&self, [d, e, n]: [Vector3<T>; 3]) -> [T; 2] {
        let axis = square_root::<ROUNDS, _>(dot(n, n), self.axis);
        let [along, across] = Self::parts([d, e, n], axis);
        let square = (along * along).plus_product(across, across);
        let inverse = T::one() / square_root::<ROUNDS, _>(square, self.radius);
        let whole = [along * inverse, across * inverse];
        let half = complex_root(whole, complex_product(self.quarter, self.quarter));
        let [cosine, sine] = complex_root(half, self.quarter).map(|part| part * self.length);
        [sine, cosine]
    }

    /// The components of `e` along and across `d`, after the parts of both along `n` are removed, each times the same
    /// length. Across is anticlockwise about `n`.
    #[inline]
    fn parts([d, e, n]: [Vector3<T>; 3], axis: T) -> [T; 2] {
        let normal = cross(n, d);
        [dot(normal, cross(n, e)) / axis, dot(normal, e)]
    }

    /// The same constraint in another number type: see [`Listing::gather`](crate::linkage::Listing::gather).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gather<M, S: Scalar>(
        of: impl Fn(&M) -> Turn<S>,
        number: &impl Fn(&dyn Fn(&M) -> S) -> T,
    ) -> Self {
        let length = number(&|model| of(model).length);
        // The inverse has all digits of the other number type, because it is part of the equation.
        Self {
            length,
            inverse: T::one() / length,
            quarter: [
                number(&|model| {
                    let [cosine, _] = of(model).quarter;
                    cosine
                }),
                number(&|model| {
                    let [_, sine] = of(model).quarter;
                    sine
                }),
            ],
            axis: number(&|model| of(model).axis),
            radius: number(&|model| of(model).radius),
        }
    }
}

/// The square root of a complex number by Heron's method: the root within a quarter of a turn of the guess.
#[inline]
fn complex_root<T: Scalar>(square: [T; 2], guess: [T; 2]) -> [T; 2] {
    let half = T::constant(0.5);
    (0..ROUNDS).fold(guess, |[x, y], _| {
        let inverse = half / (x * x).plus_product(y, y);
        let [re, im] = complex_product(square, [x, -y]);
        [
            (x * half).plus_product(re, inverse),
            (y * half).plus_product(im, inverse),
        ]
    })
}

fn complex_product<T: Scalar>([a, b]: [T; 2], [c, d]: [T; 2]) -> [T; 2] {
    [(a * c).minus_product(b, d), (a * d).plus_product(b, c)]
}

/// The coordinate `h = L sin(theta / 4)` that a driving angle about an axis prescribes, and its rates by the chain
/// rule.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn turn_to_coordinate<T: Scalar>(length: T, angle: Signal<T>) -> Signal<T> {
    let quarter = angle.map(|angle| *angle * T::constant(0.25));
    let (sine, cosine) = sine_cosine(quarter.value);
    Signal {
        value: length * sine,
        rate: length * cosine * quarter.rate,
        second_rate: length * (cosine * quarter.second_rate - sine * quarter.rate * quarter.rate),
    }
}
