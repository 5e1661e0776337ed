//! Frames of three points, and the points that they carry.

use nalgebra::Vector3;

use crate::arithmetic::pivot::growth_limit;
use crate::arithmetic::scalar::Real;
use crate::error::GeometryError;
use crate::model::constraint::{Carried, Frame, InPlane};
use crate::model::handedness::Linked;

/// The smallest sine of the angle between a frame's edges. With a smaller one, rounding errors of a body's equations
/// grow beyond the tolerance of the solver.
const FLATTEST_FRAME: f64 = 1e-2;

/// A frame of points that are not collinear; `third` is the index of its last point.
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
/// [`GeometryError::NotClosed`] if they break the triangle inequality, [`GeometryError::Collinear`] if they only just
/// meet it.
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

/// A plane through three points; `third` is the index of the last.
///
/// # Errors
///
/// [`GeometryError::Collinear`] if the points are collinear.
pub fn plane<T: Real>(third: usize, points: Frame<T>) -> Result<InPlane<T>, GeometryError> {
    let Frame { u, v, .. } = frame(third, points)?;
    Ok(InPlane::new([u.norm(), v.norm()]))
}

/// The constants of a carried point at its present position.
///
/// # Errors
///
/// [`GeometryError::Collinear`] if the frame's points are collinear.
pub fn carried<T: Real>(
    index: usize,
    point: Vector3<T>,
    frame: &Frame<T>,
) -> Result<Carried<T>, GeometryError> {
    let frame = self::frame(index, *frame)?;
    Carried::new(point, &frame).ok_or(GeometryError::Collinear { point: index })
}

/// The constants of a carried point from its distances to the frame's points, on its present side of the frame.
///
/// # Errors
///
/// [`GeometryError::NotClosed`] if no point has these distances.
pub fn carried_at<T: Real>(
    index: usize,
    now: &Carried<T>,
    frame: &Frame<T>,
    lengths: [T; 3],
) -> Result<Carried<T>, GeometryError> {
    now.with_lengths(frame, lengths)
        .ok_or(GeometryError::NotClosed { point: index })
}

/// A point at its present position, held to a frame by distances alone.
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

/// Such a point from its distances to the frame's points, on its present side of the frame.
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

/// Refuses a point whose three distances are singular: the determinant of their gradients is the volume divided by
/// the product of the lengths, and the pivots that it leaves are unhealthy.
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
