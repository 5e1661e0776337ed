//! Building blocks of a model: constants from positions or lengths, each checked.

use nalgebra::Vector3;

use crate::arithmetic::scalar::Real;
use crate::error::GeometryError;
use crate::model::constraint::{
    Bilinear, Carried, Distance, Frame, InPlane, OnLine, Product, Stretch, Turn,
};
use crate::model::handedness::Linked;
use crate::solve::factored::growth_limit;

/// Whether the fourth power is finite: constants of bodies are of that degree.
fn is_moderate<T: Real>(number: T) -> bool {
    let square = number * number;
    (square * square).is_finite()
}

/// Whether a length can be squared and divided by.
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

/// The distance of two points as they stand.
///
/// # Errors
///
/// [`GeometryError::BadLength`] where they coincide, or are too far apart to square.
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

/// A line whose ends are a length apart, `end` being the index of the last.
///
/// # Errors
///
/// [`GeometryError::NoLine`] where they coincide, or are too far apart to square.
pub fn line<T: Real>(end: usize, length: T) -> Result<OnLine<T>, GeometryError> {
    if is_usable(length) {
        Ok(OnLine::new([length]))
    } else {
        Err(GeometryError::NoLine { point: end })
    }
}

/// Two points whose length is driven, as far apart as in the design, `end` being the index of the last.
///
/// # Errors
///
/// [`GeometryError::NoLine`] where they coincide, or are too far apart to square.
pub fn stretch<T: Real>(end: usize, length: T) -> Result<Stretch<T>, GeometryError> {
    if is_usable(length) {
        Ok(Stretch::new(length))
    } else {
        Err(GeometryError::NoLine { point: end })
    }
}

/// The smallest sine of the angle between a frame's edges. With less, rounding errors of a body's
/// equations grow beyond the tolerance of the solver.
const FLATTEST_FRAME: f64 = 1e-2;

/// A frame, with `third` the index of its last point.
///
/// # Errors
///
/// [`GeometryError::Collinear`].
pub fn frame<T: Real>(third: usize, frame: Frame<T>) -> Result<Frame<T>, GeometryError> {
    let flat = T::constant(FLATTEST_FRAME) * frame.u.norm() * frame.v.norm();
    if frame.u.cross(&frame.v).norm() > flat {
        Ok(frame)
    } else {
        Err(GeometryError::Collinear { point: third })
    }
}

/// A frame at rest, from the distances first-second, first-third and second-third.
///
/// # Errors
///
/// [`GeometryError::NotClosed`] where they break the triangle inequality,
/// [`GeometryError::Collinear`] where they only just meet it.
pub fn frame_of_lengths<T: Real>(
    third: usize,
    [first_second, first_third, second_third]: [T; 3],
) -> Result<Frame<T>, GeometryError> {
    let at_rest = Frame::from_lengths(first_second, first_third, second_third);
    frame(
        third,
        at_rest.ok_or(GeometryError::NotClosed { point: third })?,
    )
}

/// A plane of three points, with `third` the index of the last.
///
/// # Errors
///
/// [`GeometryError::Collinear`] where they are in line.
pub fn plane<T: Real>(third: usize, points: Frame<T>) -> Result<InPlane<T>, GeometryError> {
    let Frame { u, v, .. } = frame(third, points)?;
    Ok(InPlane::new([u.norm(), v.norm()]))
}

/// Two lines at the angle at which they stand, `end` being the index of the last of their ends.
///
/// # Errors
///
/// [`GeometryError::NoLine`] where a line has no length, or is too long to square.
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

/// Products over the length of a line, or of two lines the geometric mean, `end` being the index of the last of their
/// ends.
///
/// # Errors
///
/// [`GeometryError::NoLine`] where a line has no length, or is too long to square.
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

/// The angle between two lines about a third one as they stand, `end` being the index of the last of their ends.
///
/// # Errors
///
/// [`GeometryError::NoLine`] where a line has no length, is too long to square, or where one of the first two is along
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

/// The constants of a carried point as it stands.
///
/// # Errors
///
/// [`GeometryError::Collinear`] where the frame's points are in line.
pub fn carried<T: Real>(
    index: usize,
    point: Vector3<T>,
    frame: &Frame<T>,
) -> Result<Carried<T>, GeometryError> {
    let frame = self::frame(index, *frame)?;
    Carried::new(point, &frame).ok_or(GeometryError::Collinear { point: index })
}

/// The constants of a carried point from its distances to the frame's points, on the side where
/// it is now.
///
/// # Errors
///
/// [`GeometryError::NotClosed`] where no point has these distances.
pub fn carried_at<T: Real>(
    index: usize,
    now: &Carried<T>,
    frame: &Frame<T>,
    lengths: [T; 3],
) -> Result<Carried<T>, GeometryError> {
    now.with_lengths(frame, lengths)
        .ok_or(GeometryError::NotClosed { point: index })
}

/// A point as it stands, held to a frame by distances alone.
///
/// # Errors
///
/// As [`carried`], and [`GeometryError::Flat`].
pub fn linked<T: Real>(
    index: usize,
    point: Vector3<T>,
    frame: &Frame<T>,
) -> Result<Linked<T>, GeometryError> {
    standing_off(index, carried(index, point, frame)?, frame)
}

/// The same from its distances to the frame's points, on the side where it is now.
///
/// # Errors
///
/// As [`carried_at`], and [`GeometryError::Flat`].
pub fn linked_at<T: Real>(
    index: usize,
    now: &Linked<T>,
    frame: &Frame<T>,
    lengths: [T; 3],
) -> Result<Linked<T>, GeometryError> {
    standing_off(
        index,
        carried_at(index, now.shape(), frame, lengths)?,
        frame,
    )
}

/// Refuses a point whose three distances are singular: the determinant of their gradients is the
/// volume over the product of the lengths, and the pivots that it leaves are unhealthy.
fn standing_off<T: Real>(
    index: usize,
    shape: Carried<T>,
    frame: &Frame<T>,
) -> Result<Linked<T>, GeometryError> {
    let off = shape.position(frame) - frame.origin;
    let volume = off.dot(&frame.u.cross(&frame.v)).abs();
    let [a, b, c] = shape.lengths(frame);
    if volume * growth_limit() > a * b * c {
        Ok(Linked::new(shape, frame))
    } else {
        Err(GeometryError::Flat { point: index })
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
    let across = ((length - coordinate) * (length + coordinate))
        .max(T::zero())
        .sqrt();
    T::arc_tangent(across, coordinate)
}
