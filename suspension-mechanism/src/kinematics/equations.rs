//! The equations of a mechanism at a place, as numbers.

use nalgebra::{DMatrix, SVector};
use suspension_core::solve::motion::Prescribed;
use suspension_core::solve::pivots::Elimination;

use crate::mechanism::{Mechanism, Suspension};

/// The equations of a mechanism at a place, as numbers.
#[derive(Clone, Debug)]
pub struct Equations {
    /// Their derivatives, one row per equation and one column per unknown. Both are lengths in the unit of the file, so
    /// the entries have no unit.
    pub jacobian: DMatrix<f64>,
    /// The fixed order of elimination.
    pub elimination: Elimination<f64>,
    /// The largest residual, in the unit of lengths.
    pub residual: f64,
}

impl Equations {
    /// The equations of a mechanism at its first instant.
    pub(super) fn evaluate<L: Suspension<N>, const N: usize>(mechanism: &Mechanism<L, N>) -> Self {
        let Mechanism { model, start, .. } = mechanism;
        let q = &start.position;
        let [first, _] = mechanism.instants.ends();
        let inputs = mechanism.drives.inputs::<L::Drives>(first);
        let Prescribed { fixed, drives } = Prescribed::new(model, &inputs);
        let (fixed, drives) = (fixed.value, drives.value);
        Self {
            jacobian: jacobian(mechanism, q, &fixed),
            elimination: Elimination::at(model, q, &fixed),
            residual: model.residual(q, &fixed, &drives).amax(),
        }
    }
}

/// The Jacobian of the listing's equations, which may be fewer than a model has room for.
pub(super) fn jacobian<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    q: &SVector<f64, N>,
    fixed: &L::Fixed,
) -> DMatrix<f64> {
    let size = mechanism.names.unknowns.len();
    let jacobian = mechanism.model.jacobian(q, fixed);
    jacobian.view((0, 0), (size, size)).into_owned()
}
