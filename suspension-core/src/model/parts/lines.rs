//! Links and lines, whose equations are divided by a length.

use nalgebra::Vector3;

use super::is_usable;
use crate::arithmetic::scalar::Real;
use crate::error::GeometryError;
use crate::model::constraint::{Bilinear, Distance, OnLine, Product, Stretch, Turn};

/// The present distance between two points.
///
/// # Errors
///
/// [`GeometryError::BadLength`] if they coincide, or are too far apart to square.
pub fn distance<T: Real>(
    length: usize,
    a: Vector3<T>,
    b: Vector3<T>,
) -> Result<Distance<T>, GeometryError> {
    let value = (b - a).norm();
    if is_usable(value) {
        Ok(Distance::new(value))
    } else {
        Err(GeometryError::BadLength { length })
    }
}

/// A line whose ends are this length apart; `end` is the index of the last.
///
/// # Errors
///
/// [`GeometryError::NoLine`] if they coincide, or are too far apart to square.
pub fn line<T: Real>(end: usize, length: T) -> Result<OnLine<T>, GeometryError> {
    if is_usable(length) {
        Ok(OnLine::new([length]))
    } else {
        Err(GeometryError::NoLine { point: end })
    }
}

/// Two points whose distance is driven, with its length in the design; `end` is the index of the last.
///
/// # Errors
///
/// [`GeometryError::NoLine`] if they coincide, or are too far apart to square.
pub fn stretch<T: Real>(end: usize, length: T) -> Result<Stretch<T>, GeometryError> {
    if is_usable(length) {
        Ok(Stretch::new(length))
    } else {
        Err(GeometryError::NoLine { point: end })
    }
}

/// Two lines at their present angle; `end` is the index of the last of their ends.
///
/// # Errors
///
/// [`GeometryError::NoLine`] if a line has no length, or is too long to square.
pub fn product<T: Real>(end: usize, lines: [Vector3<T>; 2]) -> Result<Product<T>, GeometryError> {
    let (lengths, [d, e]) = (lines.map(|line| line.norm()), lines);
    let [of_d, of_e] = lengths;
    product_at(
        end,
        &Product::new(d.dot(&e) / (of_d * of_e), lengths),
        lengths,
    )
}

/// Two lines at the same angle with other lengths.
///
/// # Errors
///
/// As [`product`].
pub fn product_at<T: Real>(
    end: usize,
    now: &Product<T>,
    lengths: [T; 2],
) -> Result<Product<T>, GeometryError> {
    if lengths.into_iter().all(is_usable) {
        Ok(Product::new(now.cosine(), lengths))
    } else {
        Err(GeometryError::NoLine { point: end })
    }
}

/// Products over the length of a line, or over the geometric mean of two lengths; `end` is the index of the last of
/// the lines' ends.
///
/// # Errors
///
/// [`GeometryError::NoLine`] if a line has no length, or is too long to square.
pub fn bilinear<T: Real, const K: usize>(
    end: usize,
    lines: [T; K],
) -> Result<Bilinear<T>, GeometryError> {
    if lines.into_iter().all(is_usable) {
        Ok(Bilinear::new(mean(lines)))
    } else {
        Err(GeometryError::NoLine { point: end })
    }
}

/// The present angle between two lines about a third one; `end` is the index of the last of their ends.
///
/// # Errors
///
/// [`GeometryError::NoLine`] if a line has no length or is too long to square, or if one of the first two is along
/// the third.
pub fn turn<T: Real>(end: usize, lines: [Vector3<T>; 3]) -> Result<Turn<T>, GeometryError> {
    let lengths = lines.map(|line| line.norm());
    let [of_d, of_e, _] = lengths;
    let turn = Turn::new(lines, mean([of_d, of_e]));
    let turn = turn.filter(|_| lengths.into_iter().all(is_usable));
    turn.ok_or(GeometryError::NoLine { point: end })
}

/// The length itself, or the geometric mean of two.
fn mean<T: Real, const K: usize>(lengths: [T; K]) -> T {
    match lengths.as_slice() {
        [length] => *length,
        lengths => {
            let roots = lengths.iter().map(|length| length.sqrt());
            roots.fold(T::one(), |mean, root| mean * root)
        }
    }
}
