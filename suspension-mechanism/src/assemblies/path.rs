//! Roots followed along a line of the family.

use nalgebra::{Complex, ComplexField};
use suspension_core::Listing;

use crate::assemblies::factors::{Factors, Vector};
use crate::assemblies::family::Line;

/// The number of terms of the predicting series.
const TERMS: usize = 10;

/// The largest error of the prediction, as a multiple of the size of the root.
const PREDICTION: f64 = 1e-6;

/// The largest correction of a prediction, as the same multiple.
const CORRECTION: f64 = 1e-4;

/// The rounding error of a correction: far from the real configurations the closure of a body is badly conditioned.
const ROUNDING: f64 = 1e-7;

/// The rounding error of a correction if a root is so large that the rounding of products of its coordinates
/// dominates, as a multiple of the square of its size. Without it, one of a double wishbone's 32 roots was lost at
/// 30,000 times the linkage's size.
const OF_PRODUCTS: f64 = 64.0 * f64::EPSILON;

/// The largest number of steps of a path.
const MOST_STEPS: usize = 400;

/// The shortest step, as a fraction of the line.
const SHORTEST: f64 = 1e-14;

/// The size above which a root may be on its way to infinity, as a multiple of the linkage's size: larger than any
/// real one. Rounding ends paths at a few times this size.
pub(crate) const FAR: f64 = 1e4;

/// How near the pole of its series must be to the end of a line, as a fraction of what is left of the line.
const POLE: f64 = 0.3;

/// The end of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum End<const N: usize> {
    /// A root of the member at the end of the line.
    Root(Vector<N>),
    /// Infinity at the end of the line, or so far away that the difference does not matter.
    Infinite,
    /// The root is not isolated, or is too far away for its rounding, or no steps are left.
    Lost,
}

/// Follows the root `q` of the first member of a way to its last.
pub(crate) fn follow<G: Listing<N>, const N: usize>(
    way: &[Line<'_, G, N>],
    q: &Vector<N>,
) -> End<N> {
    way.iter().fold(End::Root(*q), |end, line| match end {
        End::Root(q) => follow_line(line, q),
        End::Infinite | End::Lost => End::Lost,
    })
}

/// Follows a line: the Taylor series predicts, and Newton's method corrects with the factors at the predicted place,
/// which then give the next series.
fn follow_line<G: Listing<N>, const N: usize>(line: &Line<'_, G, N>, mut q: Vector<N>) -> End<N> {
    let mut s = 0.0;
    let mut factors = line.factors(&q, s);
    for _ in 0..MOST_STEPS {
        let scale = line.size() + q.camax();
        let Some(terms) = line.series(&q, s, &factors) else {
            return End::Lost;
        };
        let is_far = line.is_to_the_mechanism && scale > FAR * line.size();
        if is_far && has_pole_at(1.0 - s, &terms) {
            return End::Infinite;
        }
        let Some(step) = step(line, &q, s, &terms, scale) else {
            return End::Lost;
        };
        (q, s, factors) = step;
        if s >= 1.0 {
            return polished(line, q).map_or(End::Lost, End::Root);
        }
    }
    End::Lost
}

/// The root at the end of a line, corrected once more with factors of its own place.
fn polished<G: Listing<N>, const N: usize>(
    line: &Line<'_, G, N>,
    q: Vector<N>,
) -> Option<Vector<N>> {
    let correction = line.factors(&q, 1.0).solve(&line.residual(&q, 1.0))?;
    let is_small = correction.camax() < CORRECTION * (line.size() + q.camax());
    is_small.then(|| q - correction)
}

/// The longest step of the series that Newton's method confirms: the root, the place and the factors there.
fn step<'l, G: Listing<N>, const N: usize>(
    line: &'l Line<'_, G, N>,
    q: &Vector<N>,
    s: f64,
    terms: &[Vector<N>; TERMS],
    scale: f64,
) -> Option<(Vector<N>, f64, Factors<'l>)> {
    let mut step = reach(terms, PREDICTION * scale);
    while step >= SHORTEST {
        let there = if step < 1.0 - s { s + step } else { 1.0 };
        let predicted = q + sum(terms, there - s);
        let factors = line.factors(&predicted, there);
        let first = factors.solve(&line.residual(&predicted, there))?;
        let once = predicted - first;
        let second = factors.solve(&line.residual(&once, there))?;
        // For a root that comes from far away, the size that it has now counts.
        let scale = scale.min(line.size() + once.camax());
        let rounding = ROUNDING.max(OF_PRODUCTS * (scale / line.size()).powi(2));
        if first.camax() < CORRECTION * scale
            && second.camax() < (1e-2 * first.camax()).max(rounding * scale)
        {
            return Some((once - second, there, factors));
        }
        step = (there - s) * 0.5;
    }
    None
}

/// Whether the nearest pole of the series is at the distance `ahead`, judged by the quotient of its last two terms,
/// which for a pole of order `p` is the distance times `k / (k - 1 + p)`.
fn has_pole_at<const N: usize>(ahead: f64, terms: &[Vector<N>; TERMS]) -> bool {
    let [.., before, last] = terms;
    let largest = last.icamax();
    let way = before[largest] / last[largest];
    (way - Complex::from(ahead)).modulus() < POLE * ahead
}

/// The distance to which the series is accurate to `tolerance`, from its last two terms.
fn reach<const N: usize>(terms: &[Vector<N>; TERMS], tolerance: f64) -> f64 {
    let reach_of = |order: usize| (tolerance / terms[order - 1].camax()).powf(1.0 / order as f64);
    reach_of(TERMS).min(reach_of(TERMS - 1))
}

/// The value of the series without its constant.
fn sum<const N: usize>(terms: &[Vector<N>; TERMS], step: f64) -> Vector<N> {
    let step = Complex::from(step);
    let mut sum = Vector::zeros();
    for term in terms.iter().rev() {
        sum += term;
        sum *= step;
    }
    sum
}
