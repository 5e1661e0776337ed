//! The best rigid fit against Kabsch's by singular values, over random shapes and guesses.

use nalgebra::{Matrix3, Rotation3, Vector3};
use proptest::prelude::*;
use suspension_core::solve::assemble::best_rigid_fit;

type Points = [Vector3<f64>; 5];

fn centred(points: &Points) -> (Vector3<f64>, Points) {
    let centre = points.iter().sum::<Vector3<f64>>() / 5.0;
    (centre, points.map(|point| point - centre))
}

/// W. Kabsch 1976, with the determinant kept at +1.
fn kabsch(shape: &Points, guess: &Points) -> Points {
    let ((_, from), (centre, to)) = (centred(shape), centred(guess));
    let covariance: Matrix3<f64> = from.iter().zip(&to).map(|(a, b)| b * a.transpose()).sum();
    let svd = covariance.svd(true, true);
    let (u, v_t) = (svd.u.expect("asked for"), svd.v_t.expect("asked for"));
    let mut signs = Vector3::repeat(1.0);
    signs[svd.singular_values.imin()] = (u * v_t).determinant().signum();
    let rotation = u * Matrix3::from_diagonal(&signs) * v_t;
    from.map(|point| centre + rotation * point)
}

fn distance_between(a: &Points, b: &Points) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b).norm_squared())
        .sum::<f64>()
        .sqrt()
}

fn points(coordinates: &[f64]) -> Points {
    std::array::from_fn(|i| Vector3::from_row_slice(&coordinates[3 * i..3 * i + 3]))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn best_rigid_fit_is_as_close_as_that_of_kabsch(
        shape in prop::collection::vec(-0.3_f64..0.3, 15),
        guess in prop::collection::vec(-0.3_f64..0.3, 15),
    ) {
        let (shape, guess) = (points(&shape), points(&guess));
        let ours = best_rigid_fit(&shape, &guess);
        let reference = kabsch(&shape, &guess);
        prop_assert!(distance_between(&ours, &guess) <= distance_between(&reference, &guess) * (1.0 + 1e-9));
        // Rigid and not mirrored: the edges span the same volume.
        let volume = |p: &Points| (p[1] - p[0]).cross(&(p[2] - p[0])).dot(&(p[3] - p[0]));
        prop_assert!((volume(&ours) - volume(&shape)).abs() < 1e-14);
    }

    #[test]
    fn best_rigid_fit_recovers_a_moved_body(
        shape in prop::collection::vec(-0.3_f64..0.3, 15),
        turn in prop::collection::vec(-3.0_f64..3.0, 3),
    ) {
        let shape = points(&shape);
        let rotation = Rotation3::new(Vector3::from_row_slice(&turn));
        let moved = shape.map(|point| rotation * point + Vector3::new(-1.3, 0.4, 0.1));
        prop_assert!(distance_between(&best_rigid_fit(&shape, &moved), &moved) < 1e-14);
    }
}
