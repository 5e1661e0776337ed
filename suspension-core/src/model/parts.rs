//! Building blocks of a model: constants from positions or lengths, each checked.

mod bodies;
mod lines;

use nalgebra::Vector3;

use crate::arithmetic::scalar::Real;
use crate::error::GeometryError;

pub use bodies::{carried, carried_at, frame, frame_of_lengths, linked, linked_at, plane};
pub use lines::{bilinear, distance, line, product, product_at, stretch, turn};

/// Whether the fourth power is finite, because constants of bodies are of that degree.
fn is_moderate<T: Real>(number: T) -> bool {
    let square = number * number;
    (square * square).is_finite()
}

/// Whether a length can be squared and used as a divisor.
fn is_usable<T: Real>(length: T) -> bool {
    let square = length * length;
    length > T::zero()
        && square > T::zero()
        && is_moderate(length)
        && is_moderate(T::one() / length)
}

/// Checks that every coordinate is finite and not too large to compute with.
///
/// # Errors
///
/// [`GeometryError::NotFinite`].
pub fn finite<T: Real>(points: impl IntoIterator<Item = Vector3<T>>) -> Result<(), GeometryError> {
    check_each(
        points,
        |point| point.iter().all(|x| is_moderate(*x)),
        |point| GeometryError::NotFinite { point },
    )
}

/// Checks that every length is positive and finite.
///
/// # Errors
///
/// [`GeometryError::BadLength`].
pub fn positive<T: Real>(lengths: impl IntoIterator<Item = T>) -> Result<(), GeometryError> {
    check_each(
        lengths,
        |length| is_usable(*length),
        |length| GeometryError::BadLength { length },
    )
}

fn check_each<V>(
    values: impl IntoIterator<Item = V>,
    good: impl Fn(&V) -> bool,
    error: impl Fn(usize) -> GeometryError,
) -> Result<(), GeometryError> {
    match values.into_iter().position(|value| !good(&value)) {
        Some(index) => Err(error(index)),
        None => Ok(()),
    }
}

/// The longest of the lengths.
pub fn longest<T: Real>(lengths: &[T]) -> T {
    lengths
        .iter()
        .fold(T::zero(), |longest, length| longest.max(*length))
}

/// The angle, in `[0, pi]`, whose cosine is `coordinate / length`.
pub fn angle<T: Real>(coordinate: T, length: T) -> T {
    T::arc_tangent(other_leg(coordinate, length), coordinate)
}

/// The other leg of a right triangle; zero if rounding has made the given one longer than the hypotenuse.
pub(crate) fn other_leg<T: Real>(leg: T, hypotenuse: T) -> T {
    let square = (hypotenuse - leg) * (hypotenuse + leg);
    square.max(T::zero()).sqrt()
}
