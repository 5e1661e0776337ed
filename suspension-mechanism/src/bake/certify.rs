//! The error of a segment, measured against the solver between the places of the fit.
//!
//! The difference between polynomial and motion is sampled at the 32 Chebyshev points of each
//! segment. A polynomial of degree `d` nowhere exceeds its largest value at `m` such points by a
//! factor of more than `1 / cos(pi d / (2 m))` (Ehlich and Zeller 1964, Math. Z. 86). This factor
//! is applied with `d = 8`. The part of the difference beyond degree 8 is taken from its Chebyshev
//! coefficients up to degree 31 and added. The bound therefore holds if the part of the motion
//! beyond degree 31 in one segment is hidden by rounding, which the decay of its coefficients
//! shows; it is not a proof.

use std::array::from_fn;
use std::f64::consts::PI;

use nalgebra::Vector3;
use suspension_core::baked::polynomial;

use crate::bake::driven::Derivatives;

/// The number of samples per segment.
pub(super) const SAMPLES: usize = 32;

/// The degree up to which the factor holds.
const DEGREE: usize = 8;

/// The largest differences between a curve and the motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reached {
    /// The difference of a position, in the unit of the hardpoints.
    pub position: f64,
    /// The difference of a first derivative, in that unit per unit of the drive.
    pub first: f64,
    /// The difference of a second derivative, in that unit per unit of the drive squared.
    pub second: f64,
}

impl Reached {
    /// The differences multiplied by a factor.
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            position: self.position * factor,
            first: self.first * factor,
            second: self.second * factor,
        }
    }

    /// The larger of the two, for each difference.
    pub fn larger(self, other: Self) -> Self {
        Self {
            position: self.position.max(other.position),
            first: self.first.max(other.first),
            second: self.second.max(other.second),
        }
    }
}

/// The places in a segment, 0 to 1, where differences are sampled.
pub(super) fn places() -> [f64; SAMPLES] {
    from_fn(|index| 0.5 - 0.5 * (PI * (index as f64 + 0.5) / SAMPLES as f64).cos())
}

/// Bounds the differences of one output over a segment of length `length` from its values at
/// [`places`].
pub(super) fn bound(coefficients: &[[f64; 3]], length: f64, exact: &[Derivatives]) -> Reached {
    let mut differences: [Vec<Vector3<f64>>; 3] = Default::default();
    for (place, exact) in places().iter().zip(exact) {
        let sums: [[f64; 3]; 3] = polynomial(coefficients, *place);
        let mut scale = 1.0;
        for (order, (sum, exact)) in sums.iter().zip(exact).enumerate() {
            // Sums are divided by the factorial of their order, which is max(1, order) for 0, 1, 2.
            let derivative = Vector3::from(*sum) * (order.max(1) as f64 * scale);
            differences[order].push(derivative - exact);
            scale /= length;
        }
    }
    let [position, first, second] = differences.map(|samples| largest(&samples));
    Reached {
        position,
        first,
        second,
    }
}

/// A bound of the length of a vector over the whole segment, from its samples.
fn largest(samples: &[Vector3<f64>]) -> f64 {
    largest_between(largest_sample(samples), truncated_part(samples))
}

/// The largest length between samples, from the largest sample and the part beyond [`DEGREE`].
fn largest_between(seen: f64, beyond: f64) -> f64 {
    let between_samples = (PI * DEGREE as f64 / (2.0 * SAMPLES as f64)).cos().recip();
    (seen + beyond) * between_samples + beyond
}

fn largest_sample(samples: &[Vector3<f64>]) -> f64 {
    samples.iter().map(Vector3::norm).fold(0.0, f64::max)
}

/// The sum of the Chebyshev coefficients beyond [`DEGREE`].
fn truncated_part(samples: &[Vector3<f64>]) -> f64 {
    let count = samples.len() as f64;
    let coefficient = |degree: usize| {
        let terms = samples.iter().enumerate().map(|(index, sample)| {
            let angle = PI * degree as f64 * (index as f64 + 0.5) / count;
            sample * angle.cos()
        });
        terms.sum::<Vector3<f64>>().norm() * 2.0 / count
    };
    (DEGREE + 1..samples.len()).map(coefficient).sum()
}

/// Bounds a difference over a square from its values at [`places`] in both directions: along each
/// line of samples, then across the lines.
pub(crate) fn bound_over_square<E>(
    exact: &[Vec<E>],
    difference: impl Fn(f64, f64, &E) -> Vector3<f64>,
) -> f64 {
    let places = places();
    let at = |u: usize, v: usize| difference(places[u], places[v], &exact[u][v]);
    let (mut on_lines, mut beyond_across) = (0.0_f64, 0.0_f64);
    for fixed in 0..SAMPLES {
        let along: Vec<_> = (0..SAMPLES).map(|free| at(fixed, free)).collect();
        let across: Vec<_> = (0..SAMPLES).map(|free| at(free, fixed)).collect();
        on_lines = on_lines.max(largest(&along));
        beyond_across = beyond_across.max(truncated_part(&across));
    }
    largest_between(on_lines, beyond_across)
}
