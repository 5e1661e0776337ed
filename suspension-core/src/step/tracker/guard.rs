//! A check of whether a step may have passed singularities. It also detects an even number, which the sign of the
//! determinant does not show.
//!
//! The Jacobian is affine in the coordinates: with `J` and `q` at the end of a step `d` from `q - d`,
//! and `w` the solution of `J w = C(d, d)`,
//!
//! ```text
//! J(q - s d) d = J (d - s w),     0 <= s <= 1.
//! ```
//!
//! While `|w| < |d|` the direction of the step becomes singular nowhere between its ends. If a
//! step runs into a turning point, `|w| / |d|` grows without bound.
//!
//! This holds for a chassis at rest, and for one whose points all move by the same displacement: `d` is then the
//! displacement of the other points relative to them. For any moving chassis the mean displacement of its points is used,
//! which assumes that they move by about the same.
//!
//! Chassis points, including driven ones, enter `C` with their own displacement. It is taken from
//! their positions if the inputs before the step are known, otherwise from their rates: a link whose
//! chassis end jumps to the other side of it may leave the free points where they were, with
//! singularities between.

use core::iter::repeat;
use core::ops::{Mul, Sub};

use nalgebra::{SVector, Vector3};

use crate::arithmetic::magnitude::{index_of_largest, largest, magnitude};
use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::{Factors, Linkage, Values};
use crate::listing::{Kind, Part};
use crate::signal::{ChassisMotion, Signal};
use crate::solve::motion::Prescribed;

/// See [`change_of_jacobian`](super::Tracker::change_of_jacobian) of the tracker. Of 560,000 accepted steps of random
/// five-link suspensions, 2 ended in another assembly without it, both with a change above 3.7, and none with it.
/// With the bounds on corrections loosened fivefold, 29 of 110,000 did, with a smallest change of 1.27.
pub(super) const CHANGE_OF_JACOBIAN: f64 = 1.0;

/// The fraction of the predicted move up to which the error of a prediction leaves no doubt about the step: in the
/// same trial it was 0.19 or more if a step ended in another assembly.
const SMALL_OF_MOVE: f64 = 0.05;

/// An error, as a fraction of the linkage's size, that is small whatever the move.
const LEAST_OF_SIZE: f64 = 1e-5;

/// An error, as a fraction of the linkage's size, that is not small whatever the move.
const MOST_OF_SIZE: f64 = 1e-3;

/// Whether the error of a prediction is so small that the step needs no further proof.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn is_beyond_doubt<T: Real>(error: T, moved: T, size: T) -> bool {
    let [least, most] = [LEAST_OF_SIZE, MOST_OF_SIZE].map(|part| T::constant(part) * size);
    error <= (T::constant(SMALL_OF_MOVE) * moved).min(most).max(least)
}

/// For a move `d` between two positions, with the factors at one of them: `w` from above, and the size of `d`
/// relative to the chassis.
pub(crate) fn change_of_jacobian<L, C, const N: usize>(
    linkage: &L,
    moves: &SVector<L::Scalar, N>,
    chassis: &L::Fixed,
    factors: &dyn Factors<L::Scalar, N>,
) -> (SVector<L::Scalar, N>, L::Scalar)
where
    L: Linkage<N, Scalar: Real>,
    C: ChassisMotion<L::Fixed>,
{
    let change = factors.solve(&linkage.curvature(moves, chassis, moves, chassis));
    let [relative] = if C::MOVES {
        let with_chassis = repeat(mean::<_, L, N>(linkage, chassis));
        let points = L::Points::from_values(with_chassis);
        (*moves - linkage.unknowns(&points)).data.0
    } else {
        moves.data.0
    };
    (change, largest(relative))
}

/// The change of the inputs over a step.
pub(super) struct Change<'a, L: Linkage<N>, const N: usize> {
    /// The inputs before it, if known.
    pub(super) from: Option<&'a Prescribed<L::Fixed, L::Drives>>,
    pub(super) to: &'a Prescribed<L::Fixed, L::Drives>,
    pub(super) dt: L::Scalar,
}

impl<T: Real, L: Linkage<N, Scalar = T>, const N: usize> Change<'_, L, N> {
    /// The displacement of the chassis points.
    fn chassis_displacement<C: ChassisMotion<L::Fixed>>(&self, linkage: &L) -> L::Fixed {
        let by_rates = displacement_by_rates(&self.to.fixed, self.dt);
        by_rates.combined(&self.unexplained_displacement::<C>(linkage), |a, b| a + b)
    }

    /// The largest coordinate of the part of a chassis point's move that its rates do not explain.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn jump<C: ChassisMotion<L::Fixed>>(&self, linkage: &L) -> T {
        let points = self.unexplained_displacement::<C>(linkage);
        points.values().fold(T::zero(), |most, point| {
            let [[x, y, z]] = point.data.0;
            most.larger_magnitude(largest([x, y, z]))
        })
    }

    /// The part of the chassis points' move that their rates do not explain; zero if it is not known.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn unexplained_displacement<C: ChassisMotion<L::Fixed>>(&self, linkage: &L) -> L::Fixed {
        let (Some(from), to) = (self.from, self.to) else {
            return L::Fixed::default();
        };
        if C::MOVES {
            let moves = to.fixed.value.combined(&from.fixed.value, |a, b| a - b);
            return moves.combined(&displacement_by_rates(&to.fixed, self.dt), |a, b| a - b);
        }
        let moves = to.drives.value.combined(&from.drives.value, |a, b| a - b);
        let beyond = moves.combined(&displacement_by_rates(&to.drives, self.dt), |a, b| a - b);
        linkage.drive_anchors(L::Fixed::default(), &beyond)
    }
}

/// The displacement of quantities in the past time `dt`, according to their rates.
#[cfg_attr(not(debug_assertions), inline(always))]
fn displacement_by_rates<T, V, S>(signal: &Signal<S>, dt: T) -> S
where
    T: Real,
    V: Copy + Default + Sub<Output = V> + Mul<T, Output = V>,
    S: Values<V>,
{
    let half = dt * T::constant(0.5);
    signal
        .rate
        .combined(&signal.second_rate, |rate, second_rate| {
            (rate - second_rate * half) * dt
        })
}

/// A step from one position to another, with the factors of the Jacobian there.
pub(super) struct Crossing<'a, L: Linkage<N>, const N: usize> {
    pub(super) linkage: &'a L,
    pub(super) change: &'a Change<'a, L, N>,
    pub(super) moves: &'a SVector<L::Scalar, N>,
    pub(super) factors: &'a dyn Factors<L::Scalar, N>,
}

impl<T: Real, L: Linkage<N, Scalar = T>, const N: usize> Crossing<'_, L, N> {
    /// Refuses a step over which the Jacobian changes by more than `most` of the move.
    pub(super) fn check<C: ChassisMotion<L::Fixed>>(&self, most: T) -> Result<(), SolveError<T>> {
        let Crossing {
            linkage,
            change,
            moves,
            factors,
        } = self;
        let chassis = change.chassis_displacement::<C>(linkage);
        let (change, moved) = change_of_jacobian::<_, C, N>(*linkage, moves, &chassis, *factors);
        let size = magnitude(&change).map_err(SolveError::overflow)?;
        let bound = (most * moved).max(T::constant(LEAST_OF_SIZE) * linkage.size());
        if size <= bound {
            Ok(())
        } else {
            Err(SolveError::TooFar {
                part: Part::Unknown(index_of_largest(&change)),
                change: size,
                bound,
            })
        }
    }
}

/// The mean displacement of the chassis points.
fn mean<T, L, const N: usize>(linkage: &L, chassis: &L::Fixed) -> Vector3<T>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
{
    let count = linkage.count(Kind::ChassisPoint);
    let each = chassis.values().take(count);
    let sum = each.fold(Vector3::zeros(), |sum, point| sum + point);
    sum / T::constant(count.max(1) as f64)
}
