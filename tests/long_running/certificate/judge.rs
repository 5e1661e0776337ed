//! Whether what was proved is so, judged by roots of 30 digits.

use nalgebra::SVector;
use suspension_core::Real;
use suspension_core::certificate::Certificate;
use suspension_double_double::DoubleDouble;

use super::random::Counts;

/// A root, unknown by unknown.
pub(crate) type Root<const N: usize> = SVector<DoubleDouble, N>;

/// Distances are compared to this, relative.
const JUDGED_TO: f64 = 1e-12;

/// The two radii of a proof.
pub(crate) type Proof = Option<[f64; 2]>;

pub(crate) fn proof<T: Real>(certificate: &Certificate<T>) -> Proof {
    match certificate {
        Certificate::Proved {
            radius,
            unique_within,
        } => Some([radius, unique_within].map(nearest)),
        Certificate::Unproved { .. } => None,
    }
}

/// The same number in `f64`.
pub(crate) fn nearest<T: Real>(x: &T) -> f64 {
    x.to_subset().expect("f64 holds it")
}

/// The largest difference of any unknown.
pub(crate) fn distance<const N: usize>(root: &Root<N>, q: &SVector<f64, N>) -> f64 {
    root.iter().zip(q).fold(0.0, |largest: f64, (root, q)| {
        largest.max((*root - DoubleDouble::from(*q)).nearest().abs())
    })
}

/// Counts a case whose roots are known, all of them that may lie near by.
///
/// # Panics
///
/// Where the proof is false.
pub(crate) fn judge<const N: usize>(
    proof: Proof,
    q: &SVector<f64, N>,
    roots: &[Root<N>],
    case: impl std::fmt::Debug,
) -> Counts {
    let mut counts = Counts {
        cases: 1,
        ..Counts::default()
    };
    let Some([radius, unique_within]) = proof else {
        if roots.is_empty() {
            counts.refused = 1;
        } else {
            counts.unproved = 1;
        }
        return counts;
    };
    let mut distances: Vec<f64> = roots.iter().map(|root| distance(root, q)).collect();
    distances.sort_by(f64::total_cmp);
    let what = || format!("{case:?}: {proof:?}, roots at {distances:?}");
    assert!(0.0 < radius && radius <= unique_within, "{}", what());
    assert!(
        distances
            .first()
            .is_some_and(|nearest| *nearest <= radius * (1.0 + JUDGED_TO)),
        "no root is there: {}",
        what()
    );
    assert!(
        distances[1..]
            .iter()
            .all(|other| *other >= unique_within * (1.0 - JUDGED_TO)),
        "it is not the only one: {}",
        what()
    );
    counts.proved = 1;
    counts
}

/// The square root, of a positive number.
pub(crate) fn square_root(x: DoubleDouble) -> DoubleDouble {
    let near = DoubleDouble::from(x.nearest().sqrt());
    (near + x / near) * DoubleDouble::from(0.5)
}
