//! The rigid body nearest to a guess.

use nalgebra::{Matrix3, Matrix4, Quaternion, UnitQuaternion, Vector3, Vector4};

use crate::arithmetic::scalar::Real;

/// The rigid body `shape`, moved (never mirrored) to where it fits `guess` best in the least-squares sense. A guess
/// that is not finite, or whose points coincide, is returned unchanged.
pub fn best_rigid_fit<T: Real, const K: usize>(
    shape: &[Vector3<T>; K],
    guess: &[Vector3<T>; K],
) -> [Vector3<T>; K] {
    match best_rigid_motion(shape, guess) {
        Some(motion) => shape.map(motion),
        None => *guess,
    }
}

/// The motion of the rigid body `shape` to that place, point by point: Horn 1987, Closed-form solution of absolute
/// orientation using unit quaternions. `None` if the guess is not finite, or its points coincide.
pub fn best_rigid_motion<T: Real>(
    shape: &[Vector3<T>],
    guess: &[Vector3<T>],
) -> Option<impl Fn(Vector3<T>) -> Vector3<T> + use<T>> {
    let (shape_centre, guess_centre) = (centroid(shape), centroid(guess));
    let mut covariance = Matrix3::zeros();
    for (from, to) in shape.iter().zip(guess) {
        covariance += (from - shape_centre) * (to - guess_centre).transpose();
    }
    let rotation = best_rotation(&covariance)?;
    Some(move |point| guess_centre + rotation * (point - shape_centre))
}

fn centroid<T: Real>(points: &[Vector3<T>]) -> Vector3<T> {
    points.iter().sum::<Vector3<T>>() / T::constant(points.len() as f64)
}

/// The eigenvector of Horn's matrix that belongs to its largest eigenvalue, as a quaternion:
/// a column of the matrix, made positive and squared until only that eigenvector is left.
fn best_rotation<T: Real>(s: &Matrix3<T>) -> Option<UnitQuaternion<T>> {
    const SQUARINGS: usize = 40;
    let (x, y, z) = (s.m23 - s.m32, s.m31 - s.m13, s.m12 - s.m21);
    #[rustfmt::skip]
    let horn = Matrix4::new(
        s.m11 + s.m22 + s.m33, x, y, z,
        x, s.m11 - s.m22 - s.m33, s.m12 + s.m21, s.m31 + s.m13,
        y, s.m12 + s.m21, s.m22 - s.m11 - s.m33, s.m23 + s.m32,
        z, s.m31 + s.m13, s.m23 + s.m32, s.m33 - s.m11 - s.m22,
    );
    let mut power = horn + Matrix4::from_diagonal_element(horn.norm());
    for _ in 0..SQUARINGS {
        power /= power.trace();
        power *= power;
    }
    let columns = power.column_iter();
    let longest = columns.fold(Vector4::zeros(), |longest, column| {
        if column.norm_squared() > longest.norm_squared() {
            column.into_owned()
        } else {
            longest
        }
    });
    let usable = longest.norm_squared() > T::zero() && longest.iter().all(|x| x.is_finite());
    usable.then(|| {
        let quaternion = Quaternion::new(longest.x, longest.y, longest.z, longest.w);
        UnitQuaternion::new_normalize(quaternion)
    })
}
