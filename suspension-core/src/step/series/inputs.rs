//! Inputs over a span of time: drives and chassis points as polynomials.

use core::iter::repeat;

use nalgebra::Vector3;

use super::jet::Jet;
use crate::arithmetic::scalar::Scalar;
use crate::linkage::{Linkage, Values};
use crate::listing::DriveKind;
use crate::signal::{ChassisMotion, Inputs, Signal, Still};

/// [`Inputs`] over a span of time. `chassis` is [`Still`] or the [`Jet`] of the chassis points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InputSeries<C, D, const K: usize> {
    /// The motion of the chassis points.
    pub chassis: C,
    /// The drives, in the unit of the hardpoints and radians.
    pub drives: Jet<D, K>,
}

impl<D, const K: usize> InputSeries<Still, D, K> {
    /// Inputs with the chassis points at rest at their positions in the model.
    pub fn still(drives: Jet<D, K>) -> Self {
        Self {
            chassis: Still,
            drives,
        }
    }
}

impl<C, D, const K: usize> InputSeries<C, D, K> {
    /// The inputs at the time `dt` from the instant of the series.
    pub fn at<T, F>(&self, dt: T) -> Inputs<C::At, D>
    where
        T: Scalar,
        D: Values<T>,
        C: ChassisSeries<T, F, K>,
    {
        Inputs {
            chassis: self.chassis.at(dt),
            drives: self.drives.signal(dt),
        }
    }
}

/// The motion of the chassis points `F` over a span of time.
pub trait ChassisSeries<T, F, const K: usize>: Copy {
    /// Their motion at one instant.
    type At: ChassisMotion<F>;

    /// Their motion at the time `dt` from the instant of the series.
    fn at(&self, dt: T) -> Self::At;

    /// Their Taylor coefficients, given the positions `rest` in the model.
    fn jet(&self, rest: &F) -> Jet<F, K>;
}

impl<T: Scalar, F: Values<Vector3<T>> + Default, const K: usize> ChassisSeries<T, F, K> for Still {
    type At = Self;

    fn at(&self, _dt: T) -> Self {
        Self
    }

    fn jet(&self, rest: &F) -> Jet<F, K> {
        Jet::constant(*rest, F::default())
    }
}

impl<T: Scalar, F: Values<Vector3<T>>, const K: usize> ChassisSeries<T, F, K> for Jet<F, K> {
    type At = Signal<F>;

    fn at(&self, dt: T) -> Signal<F> {
        self.signal(dt)
    }

    fn jet(&self, _rest: &F) -> Self {
        *self
    }
}

/// Input series in the form in which the equations take them.
pub(super) struct PrescribedSeries<F, D, const K: usize> {
    /// Chassis points, with the driven coordinates inserted.
    pub(super) fixed: Jet<F, K>,
    /// Drives, with angles converted to coordinates.
    pub(super) drives: Jet<D, K>,
}

impl<F: Copy, D: Copy, const K: usize> PrescribedSeries<F, D, K> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn new<L, C, const N: usize>(linkage: &L, inputs: &InputSeries<C, D, K>) -> Self
    where
        L: Linkage<N, Fixed = F, Drives = D>,
        C: ChassisSeries<L::Scalar, F, K>,
    {
        let drives = coordinates(linkage, &inputs.drives);
        let mut fixed = inputs.chassis.jet(linkage.fixed());
        linkage.put_drives(&mut fixed.value, &drives.value);
        for (fixed, drives) in fixed.terms.iter_mut().zip(&drives.terms) {
            linkage.put_drives(fixed, drives);
        }
        Self { fixed, drives }
    }
}

/// Taylor coefficients of the coordinates `h(theta(t))` that drives `theta` prescribe.
///
/// With `g = dh/dtheta`, `h' = g theta'`. For an angle, whose coordinate is `L cos(theta)`, `g' = -h theta'`; for an
/// angle about an axis, with `L sin(theta / 4)`, `g' = -h theta' / 16`; for a coordinate `g' = 0` (Griewank, Walther
/// 2008, Evaluating Derivatives, table 13.2).
fn coordinates<L, const N: usize, const K: usize>(
    linkage: &L,
    drives: &Jet<L::Drives, K>,
) -> Jet<L::Drives, K>
where
    L: Linkage<N>,
{
    let zero = L::Drives::default();
    let start = linkage.coordinates(&Signal {
        value: drives.value,
        rate: L::Drives::from_values(repeat(L::Scalar::constant(1.0))),
        second_rate: zero,
    });
    let bends = L::Drives::from_values((0..).map(|drive| match linkage.drive_kind(drive) {
        DriveKind::Angle => L::Scalar::constant(-1.0),
        DriveKind::Turn => L::Scalar::constant(-1.0 / 16.0),
        DriveKind::Coordinate => L::Scalar::constant(0.0),
    }));
    let mut h = Jet::constant(start.value, zero);
    let mut g = Jet::constant(start.rate, zero);
    for order in 1..=K {
        let next_h = chain_rule(drives, &g, order);
        let next_g = bends.combined(&chain_rule(drives, &h, order), |a, b| a * b);
        for (jet, next) in [(&mut h, next_h), (&mut g, next_g)] {
            if let Some(term) = jet.terms.get_mut(order - 1) {
                *term = next;
            }
        }
    }
    h
}

/// The coefficient of the given order of a quantity whose rate is `slope` times that of `drives`:
/// `1/k sum_{j=1}^{k} j drives_j slope_{k-j}`.
fn chain_rule<T, D, const K: usize>(drives: &Jet<D, K>, slope: &Jet<D, K>, order: usize) -> D
where
    T: Scalar,
    D: Values<T> + Default,
{
    let (mut sum, mut j) = (D::default(), T::zero());
    for (term, slope) in drives.terms.iter().zip(slope.below(order).rev()) {
        j += T::one();
        let product = term.combined(slope, |term, slope| term * slope);
        sum = sum.combined(&product, |sum, product| sum + product * j);
    }
    let order = T::constant(order as f64);
    sum.map(|sum| sum / order)
}
