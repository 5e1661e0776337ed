//! A mechanism whose drives have given values: how it locks there, and its configuration nearest to a curve.

use nalgebra::SVector;
use suspension_core::solve::lu::Lu;
use suspension_core::solve::motion::Prescribed;
use suspension_core::{Inputs, Linkage, Still};

use crate::mechanism::suspension::Suspension;

/// The largest number of corrections of a configuration.
const CORRECTIONS: usize = 30;

/// The change of the configuration below which the corrections end, as a fraction of the mechanism's size.
const CORRECTED: f64 = 1e-9;

/// The longest step along the configurations that all other equations allow, as a fraction of the mechanism's size.
const LONGEST: f64 = 0.1;

/// A mechanism at its lock. The rows of its Jacobian `J` are linearly dependent, `f^T J = 0`, and a motion `v`
/// changes no equation to first order, `J v = 0`. To second order a drive `s` with `f^T dF/ds = 1` has
/// `s'' = -f^T C(v, v)` along it: the equations with large `f_k C_k(v, v)` prevent the drive from going further. The
/// forces `f` alone do not show which these are: a link that bears much and does not rotate has `C_k(v, v) = 0`.
pub(super) struct AtLock<const N: usize> {
    /// `f`, a unit vector.
    pub(super) forces: SVector<f64, N>,
    /// The share of each equation, `f_k C_k(v, v) / f^T C(v, v)`. Their sum is one; equations with a negative share
    /// let the drive go on. A link has `C_k(v, v) > 0`: if its share is positive, the drive would go on if it were longer,
    /// otherwise if it were shorter.
    pub(super) shares: SVector<f64, N>,
    /// `v`, a unit vector.
    pub(super) along: SVector<f64, N>,
}

/// A mechanism whose drives have given values.
pub(super) struct AtDrives<'a, L: Linkage<N>, const N: usize> {
    model: &'a L,
    fixed: L::Fixed,
    drives: L::Drives,
}

impl<'a, L: Suspension<N>, const N: usize> AtDrives<'a, L, N> {
    pub(super) fn new(model: &'a L, inputs: &Inputs<Still, L::Drives>) -> Self {
        let Prescribed { fixed, drives } = Prescribed::new(model, inputs);
        Self {
            model,
            fixed: fixed.value,
            drives: drives.value,
        }
    }

    pub(super) fn residual(&self, q: &SVector<f64, N>) -> SVector<f64, N> {
        self.model.residual(q, &self.fixed, &self.drives)
    }

    /// `f` and `v` by inverse iteration: they are the singular vectors of the smallest singular value.
    pub(super) fn analyse_lock(&self, q: &SVector<f64, N>) -> Option<AtLock<N>> {
        let still = L::Fixed::default();
        let factors = Lu::factor(&self.model.jacobian(q, &self.fixed)).ok()?;
        let mut forces = SVector::<f64, N>::from_element(1.0);
        let mut along = forces;
        for _ in 0..3 {
            along = factors.solve(&forces).normalize();
            forces = factors.solve_transposed(&along).normalize();
        }
        let bend = self.model.curvature(&along, &still, &along, &still);
        let shares = forces.component_mul(&bend) / forces.dot(&bend);
        Some(AtLock {
            forces,
            shares,
            along,
        })
    }

    /// The configuration where all equations but that of a link hold and the error of this one is as small as
    /// possible. The configurations that the others allow form a curve, with a direction near `along`; Newton's
    /// method moves on it to where the link's error is stationary.
    pub(super) fn nearest(
        &self,
        mut q: SVector<f64, N>,
        link: usize,
        along: &mut SVector<f64, N>,
    ) -> Option<SVector<f64, N>> {
        let still = L::Fixed::default();
        let size = self.model.size();
        let others = |mut rows: SVector<f64, N>| {
            rows[link] = 0.0;
            rows
        };
        let mut alone = SVector::zeros();
        alone[link] = 1.0;
        for _ in 0..CORRECTIONS {
            let mut jacobian = self.model.jacobian(&q, &self.fixed);
            let of_link = jacobian.row(link).transpose();
            jacobian.set_row(link, &along.transpose());
            let factors = Lu::factor(&jacobian).ok()?;
            let tangent = factors.solve(&alone);
            let residual = self.residual(&q);
            let onto_curve = factors.solve(&others(residual));
            let bend = self.model.curvature(&tangent, &still, &tangent, &still);
            let bent = factors.solve(&others(bend));
            let off = residual[link] - of_link.dot(&onto_curve);
            let slope = of_link.dot(&tangent);
            let second_slope = bend[link] - of_link.dot(&bent);
            let step = if off * second_slope > 0.0 {
                slope / second_slope
            } else {
                (off * slope).signum() * LONGEST * size
            };
            let step = step.clamp(-LONGEST * size, LONGEST * size);
            let correction = onto_curve + tangent * step;
            q -= correction;
            *along = tangent.normalize();
            if correction.amax() < CORRECTED * size {
                break;
            }
        }
        Some(q)
    }
}
