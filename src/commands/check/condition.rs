//! The Jacobian at the design position: its rank, its singular values and its pivots.

use nalgebra::{DMatrix, DVectorView};
use suspension_core::listing::{Part, Parts};
use suspension_core::solve::pivots::Elimination;

use crate::kinematics::{Equations, Kinematics};
use crate::mechanism::Names;

/// Smaller singular values count as zero: they leave no correct digit in a velocity.
const ZERO: f64 = 1e-7;

/// An equation or unknown is named if its entry is at least this part of the largest entry of a null vector.
const SHARE: f64 = 0.05;

/// Rank, conditioning and order of elimination of the Jacobian.
pub(super) struct Condition {
    /// The number of independent equations.
    pub(super) rank: usize,
    /// Equations that depend on each other.
    pub(super) redundant: Vec<String>,
    /// Unknowns that no equation determines.
    pub(super) undetermined: Vec<String>,
    /// The smallest and the largest singular value.
    pub(super) singular_values: [f64; 2],
    /// The fixed order of elimination.
    pub(super) elimination: Elimination<f64>,
    /// The largest residual, in the unit of lengths.
    pub(super) residual: f64,
}

impl Condition {
    /// Analyses the Jacobian of a mechanism at its design position.
    pub(super) fn analyse(mechanism: &dyn Kinematics) -> Self {
        let names = &mechanism.names;
        let Equations {
            jacobian,
            elimination,
            residual,
        } = mechanism.equations();
        let size = jacobian.nrows();
        let svd = jacobian.svd(true, true);
        let values = svd.singular_values.as_slice();
        let null = (0..size).filter(|index| values[*index] < ZERO);
        let null: Vec<usize> = null.collect();
        let (left, right) = (svd.u, svd.v_t.map(|transposed| transposed.transpose()));
        let of_null = |vectors: &Option<DMatrix<f64>>, part: fn(usize) -> Part| {
            let vectors = vectors.iter();
            let null = vectors.flat_map(|vectors| null.iter().map(|index| vectors.column(*index)));
            named(names, null, part)
        };
        Self {
            rank: size - null.len(),
            redundant: of_null(&left, Part::Equation),
            undetermined: of_null(&right, Part::Unknown),
            singular_values: [
                values.iter().copied().fold(f64::INFINITY, f64::min),
                values.iter().copied().fold(0.0, f64::max),
            ],
            elimination,
            residual,
        }
    }

    /// Returns whether the drives do not determine the motion.
    pub(super) fn is_singular(&self) -> bool {
        !self.undetermined.is_empty()
    }
}

/// Returns the names of the parts with a share in any of the vectors.
fn named<'a>(
    names: &Names,
    vectors: impl Iterator<Item = DVectorView<'a, f64>>,
    part: fn(usize) -> Part,
) -> Vec<String> {
    let mut has_share = vec![false; names.unknowns.len()];
    for vector in vectors {
        for (has_share, entry) in has_share.iter_mut().zip(vector.iter()) {
            *has_share |= entry.abs() > SHARE * vector.amax();
        }
    }
    let parts = has_share.iter().enumerate().filter(|(_, share)| **share);
    let name = |(index, _)| format!("`{}`", names.name(part(index)));
    parts.map(name).collect()
}
