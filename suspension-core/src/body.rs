//! A rigid body from three of its points: pose, angular velocity and acceleration.
//!
//! The points may be any three that are not in line; arrays hold their positions, velocities or
//! accelerations in the same order. Results are in the axes of the points.

use nalgebra::{Isometry3, Matrix3, Rotation3, Translation3, UnitQuaternion, Vector3};

use crate::arithmetic::scalar::Real;
use crate::error::Indeterminate;
use crate::model::constraint::Frame;
use crate::signal::Number;

type Triple<T> = [Vector3<T>; 3];

/// The motion that carries the body from `design` to `now`; `None` if the three points are collinear in either.
pub fn pose<T: Real>(design: &Triple<T>, now: &Triple<T>) -> Option<Isometry3<T>> {
    let rotation = axes(now)? * axes(design)?.transpose();
    let [from, ..] = design;
    let [to, ..] = now;
    let translation = Translation3::from(to - rotation * from);
    let rotation = Rotation3::from_matrix_unchecked(rotation);
    Some(Isometry3::from_parts(
        translation,
        UnitQuaternion::from_rotation_matrix(&rotation),
    ))
}

/// Right-handed orthonormal axes, in columns: along the first edge, normal to it in the plane of the points, and
/// normal to that plane.
fn axes<T: Real>([a, b, c]: &Triple<T>) -> Option<Matrix3<T>> {
    let frame = Frame::new(*a, *b, *c);
    let normal = frame.normal()?.normalize();
    let along = frame.u.normalize();
    Some(Matrix3::from_columns(&[
        along,
        normal.cross(&along),
        normal,
    ]))
}

/// Angular velocity, rad/s: the least-squares fit of `v = v0 + omega x r` over three points.
///
/// Unlike [`angular_velocity_eq9`] it is defined wherever the points are not collinear. `None` if they are, or if a
/// number is not finite.
pub fn angular_velocity<T: Real>(at: &Triple<T>, velocities: &Triple<T>) -> Option<Vector3<T>> {
    fit_rotation(at, velocities)
}

/// The angular velocity, in numbers that may carry derivatives, which the result then carries too. With the edges `u`
/// and `v` from the first point and `n = u x v` it is `(n x n' + n (n x u) . u' / |u|^2) / |n|^2`.
///
/// The velocities must be those of a rigid body. The result is not finite if the points are collinear.
pub fn angular_velocity_of<N: Number>(
    [a, b, c]: &[Vector3<N>; 3],
    [a_rate, b_rate, c_rate]: &[Vector3<N>; 3],
) -> Vector3<N> {
    let (u, v) = (b - a, c - a);
    let (u_rate, v_rate) = (b_rate - a_rate, c_rate - a_rate);
    let normal = u.cross(&v);
    let normal_rate = u_rate.cross(&v) + u.cross(&v_rate);
    let about_normal = normal.cross(&u).dot(&u_rate) / u.dot(&u);
    (normal.cross(&normal_rate) + normal * about_normal) / normal.dot(&normal)
}

/// Angular acceleration, rad/s^2: the least-squares fit of `a = a0 + alpha x r + omega x (omega x r)` over three
/// points; `None` if they are collinear, or if a number is not finite.
pub fn angular_acceleration<T: Real>(
    at: &Triple<T>,
    omega: &Vector3<T>,
    accelerations: &Triple<T>,
) -> Option<Vector3<T>> {
    fit_rotation(at, &subtract_centripetal(at, omega, accelerations))
}

/// Accelerations minus `omega x (omega x r)`, with `r` from the first point: Attia 2003, below eq. (10).
fn subtract_centripetal<T: Real>(
    at: &Triple<T>,
    omega: &Vector3<T>,
    accelerations: &Triple<T>,
) -> Triple<T> {
    let [a, b, c] = at;
    let [acc_a, acc_b, acc_c] = accelerations;
    let tangential = |r: &Vector3<T>, acc: &Vector3<T>| acc - omega.cross(&omega.cross(&(r - a)));
    [*acc_a, tangential(b, acc_b), tangential(c, acc_c)]
}

/// The vector `w` for which `w x r` best fits the differences of `rates`, with `r` measured from the centroid: `sum
/// (|r|^2 - r r') w = sum r x rate`. `None` if the points are collinear, or if a number is not finite.
fn fit_rotation<T: Real>(at: &Triple<T>, rates: &Triple<T>) -> Option<Vector3<T>> {
    let [a, b, c] = at;
    Frame::new(*a, *b, *c).normal()?;
    let centroid = mean(at);
    let from_centroid = [a - centroid, b - centroid, c - centroid];
    let of_one =
        |r: &Vector3<T>| Matrix3::from_diagonal_element(r.norm_squared()) - r * r.transpose();
    let inertia: Matrix3<T> = from_centroid.iter().map(of_one).sum();
    // Scaled to the order of 1, so that the determinant neither overflows nor vanishes.
    let size = inertia.trace();
    let inverse = (inertia / size).try_inverse()?;
    let mean_rate = mean(rates);
    let moments = from_centroid.iter().zip(rates);
    let moment: Vector3<T> = moments.map(|(r, rate)| r.cross(&(rate - mean_rate))).sum();
    let rotation = inverse * (moment / size);
    rotation.iter().all(|x| x.is_finite()).then_some(rotation)
}

fn mean<T: Real>([a, b, c]: &Triple<T>) -> Vector3<T> {
    (a + b + c) / T::constant(3.0)
}

/// Angular velocity by Attia 2003, eq. (9): `(a' x b') / (a' . b)`, where `a`, `b` are the edges from the first point
/// and `a'`, `b'` their rates.
///
/// # Errors
///
/// The formula is 0/0 wherever the angular velocity lies in the plane of the three points, although it is well
/// defined there; [`angular_velocity`] has no such gap.
pub fn angular_velocity_eq9<T: Real>(
    at: &Triple<T>,
    velocities: &Triple<T>,
) -> Result<Vector3<T>, Indeterminate<T>> {
    quotient(at, velocities)
}

/// Angular acceleration by Attia 2003, eq. (10): `(a^ x b^) / (a^ . b)`, where `a`, `b` are the edges from the first
/// point and `a^`, `b^` their second rates minus `omega x (omega x a)` and `omega x (omega x b)`.
///
/// # Errors
///
/// The formula is 0/0 wherever the angular acceleration lies in the plane of the three points;
/// [`angular_acceleration`] has no such gap.
pub fn angular_acceleration_eq10<T: Real>(
    at: &Triple<T>,
    omega: &Vector3<T>,
    accelerations: &Triple<T>,
) -> Result<Vector3<T>, Indeterminate<T>> {
    quotient(at, &subtract_centripetal(at, omega, accelerations))
}

/// The vector `w` with `w x a = a'` and `w x b = b'` for the edges `a`, `b` and their `rates`: `(a' x b') / (a' .
/// b)`. Refused if the denominator `w . (a x b)` is zero to rounding.
fn quotient<T: Real>(at: &Triple<T>, rates: &Triple<T>) -> Result<Vector3<T>, Indeterminate<T>> {
    let [edges, rates] = [at, rates].map(|[a, b, c]| Frame::new(*a, *b, *c));
    let denominator = rates.u.dot(&edges.v);
    // One edge may lie along the axis of rotation, and its rate then consists of rounding errors only.
    let turning = (rates.u.norm() * edges.v.norm()).max(edges.u.norm() * rates.v.norm());
    let threshold = T::EPSILON.sqrt() * turning;
    if denominator.abs() > threshold {
        Ok(rates.u.cross(&rates.v) / denominator)
    } else {
        Err(Indeterminate {
            denominator,
            threshold,
        })
    }
}
