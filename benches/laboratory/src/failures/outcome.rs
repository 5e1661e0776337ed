//! The outcome of a trial.

use nalgebra::{SVector, Vector3};

/// The outcome of a trial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The configuration that was meant.
    Right,
    /// Another, given out as a result.
    Wrong {
        /// Whether a body is mirrored.
        mirrored: bool,
    },
    /// No root, as the method reports.
    NoRoot,
}

/// Outcomes, counted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Counts {
    /// All trials.
    pub trials: usize,
    /// The right configuration.
    pub right: usize,
    /// Another, given out as a result.
    pub wrong: usize,
    /// The number of these in which a body is mirrored.
    pub mirrored: usize,
    /// The number without a root, as the method reports.
    pub no_root: usize,
    /// The largest residual of a result, in the unit of length.
    pub residual: f64,
}

impl Counts {
    /// Adds a trial and the largest residual of its results.
    pub fn add(&mut self, outcome: Outcome, residual: f64) {
        self.trials += 1;
        self.residual = self.residual.max(residual);
        match outcome {
            Outcome::Right => self.right += 1,
            Outcome::NoRoot => self.no_root += 1,
            Outcome::Wrong { mirrored } => {
                self.wrong += 1;
                self.mirrored += usize::from(mirrored);
            }
        }
    }
}

/// Compares a result with the intended configuration: right if no coordinate differs by more than `tolerance`.
pub fn judged<const N: usize>(
    found: &SVector<f64, N>,
    meant: &SVector<f64, N>,
    tolerance: f64,
) -> Outcome {
    if (found - meant).iter().all(|off| off.abs() <= tolerance) {
        Outcome::Right
    } else {
        Outcome::Wrong {
            mirrored: has_mirrored_body(found, meant),
        }
    }
}

/// Returns whether four points have the same six distances but the opposite handedness.
fn has_mirrored_body<const N: usize>(found: &SVector<f64, N>, meant: &SVector<f64, N>) -> bool {
    let points = |q: &SVector<f64, N>| -> Vec<Vector3<f64>> {
        let points = q.as_slice().chunks_exact(3);
        points.map(Vector3::from_column_slice).collect()
    };
    let (found, meant) = (points(found), points(meant));
    let count = found.len();
    let fours = (0..count).flat_map(|a| {
        (a + 1..count).flat_map(move |b| {
            (b + 1..count).flat_map(move |c| (c + 1..count).map(move |d| [a, b, c, d]))
        })
    });
    fours.into_iter().any(|corners| {
        let [found, meant] = [&found, &meant].map(|points| corners.map(|i| points[i]));
        is_mirror_image(&found, &meant)
    })
}

/// Distances count as equal up to this part of a length.
const SAME: f64 = 1e-3;

fn is_mirror_image(found: &[Vector3<f64>; 4], meant: &[Vector3<f64>; 4]) -> bool {
    let volume = |[a, b, c, d]: &[Vector3<f64>; 4]| (b - a).cross(&(c - a)).dot(&(d - a));
    let same_distances = (0..4).all(|i| {
        (0..i).all(|j| {
            let meant = (meant[i] - meant[j]).norm();
            ((found[i] - found[j]).norm() - meant).abs() < SAME * meant
        })
    });
    same_distances && volume(found) * volume(meant) < 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mirror_image_is_distinguished_from_another_wrong_root() {
        let meant = SVector::<f64, 12>::from_row_slice(&[
            0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.2, 0.3, 0.4,
        ]);
        let mut mirrored = meant;
        mirrored[11] = -0.4;
        let moved = meant.add_scalar(0.5);
        assert_eq!(judged(&meant, &meant, 1e-4), Outcome::Right);
        let wrong = |found| judged(found, &meant, 1e-4);
        assert_eq!(wrong(&mirrored), Outcome::Wrong { mirrored: true });
        assert_eq!(wrong(&moved), Outcome::Wrong { mirrored: false });
    }

    #[test]
    fn a_nan_result_does_not_count_as_right() {
        let meant = SVector::<f64, 3>::zeros();
        let found = SVector::<f64, 3>::new(f64::NAN, 0.0, 0.0);
        assert_ne!(judged(&found, &meant, 1e-4), Outcome::Right);
    }
}
