//! A point on the wrong side of the vehicle.

use nalgebra::Vector3;
use suspension_core::Values;

use crate::mechanism::{Names, Wheel};
use crate::prepare::task::Task;

/// The distance from the middle of the vehicle within which a point is in the middle, as a fraction of the wheel's
/// distance.
const MIDDLE: f64 = 1e-6;

/// The same for a pick-up point: those of dampers and the like may well be a little beyond the middle.
const MIDDLE_OF_PICK_UPS: f64 = 0.2;

/// The only point on the other side of the vehicle than a wheel's centre, of points with their y and whether they are
/// pick-up points on the chassis: its y probably has the wrong sign. If there are several, they may well belong to
/// the other wheel.
fn only_on_wrong_side<T>(
    points: impl IntoIterator<Item = (T, f64, bool)>,
    centre: f64,
) -> Option<T> {
    let is_across = |y: f64, is_pick_up: bool| {
        let middle = if is_pick_up {
            MIDDLE_OF_PICK_UPS
        } else {
            MIDDLE
        };
        y * centre < 0.0 && y.abs() > middle * centre.abs()
    };
    let points = points.into_iter();
    let mut points = points.filter(|(_, y, is_pick_up)| is_across(*y, *is_pick_up));
    let (point, ..) = points.next()?;
    points.next().is_none().then_some(point)
}

/// Notes on points that were given on the other side of the vehicle than their wheels.
pub(in crate::prepare) fn notes<P: Values<Vector3<f64>>>(
    task: &Task<'_>,
    given: &P,
) -> Vec<String> {
    let wheels = task.names.wheels.iter();
    wheels
        .filter_map(|wheel| note_on_side(task, given, wheel))
        .collect()
}

/// A note on a point on the other side of the vehicle than its wheel, pick-up points included. The point belongs to a
/// corner or, if there are several wheels, has the wheel's name in its own.
fn note_on_side<P: Values<Vector3<f64>>>(
    task: &Task<'_>,
    given: &P,
    wheel: &Wheel,
) -> Option<String> {
    let names = &task.names;
    if wheel.name.is_empty() && names.wheels.len() > 1 {
        return None;
    }
    let [_, centre] = wheel.points.axis;
    let y: Vec<f64> = given.values().map(|point| task.y_in_file(&point)).collect();
    let words = || wheel.name.split('_').filter(|word| !word.is_empty());
    let is_of_wheel = |name: &str| words().all(|word| name.split('_').any(|other| other == word));
    let points = names.points.iter().zip(y.iter().copied()).enumerate();
    let points = points.map(|(point, (name, y))| (name, y, point < names.chassis));
    let of_wheel = points.filter(|(name, ..)| is_of_wheel(name));
    let point = only_on_wrong_side(of_wheel, y[centre])?;
    if is_on_long_hinge(names, given, point) {
        return None;
    }
    let centre = &names.points[centre];
    Some(format!(
        "`{point}` is on the other side of the vehicle than `{centre}`: is the sign of its y right?"
    ))
}

/// Whether a point is on a hinge line that is much longer along the vehicle than across it, and so may well cross the
/// middle: that of an I-beam, from its pivot on the other side to the bush of its radius arm.
fn is_on_long_hinge<P: Values<Vector3<f64>>>(names: &Names, given: &P, point: &str) -> bool {
    /// How much longer: the line of a wishbone with a wrong sign, about twice as long across as its bushes are from
    /// the middle, is shorter.
    const MUCH: f64 = 1.4;
    let place = |name: &String| given.values().nth(names.point(name)?);
    let mut hinges = names.hinges.iter().map(|hinge| hinge.axis.as_slice());
    hinges.any(|axis| match axis {
        [from, to] if [from, to].iter().any(|end| *end == point) => {
            let ends = place(from).zip(place(to));
            ends.is_some_and(|(from, to)| (to.x - from.x).abs() > MUCH * (to.y - from.y).abs())
        }
        _ => false,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_single_point_on_the_wrong_side_is_found_but_not_several() {
        for (others, expected) in [
            ([0.7, 0.6, 0.1], None),
            ([0.7, -0.6, 0.1], Some(1)),
            ([0.7, -1e-12, 0.1], None),
            ([-0.7, -0.6, 0.1], None),
        ] {
            let points =
                |y: [f64; 3], pick_up| (0..).zip(y).map(move |(point, y)| (point, y, pick_up));
            assert_eq!(only_on_wrong_side(points(others, false), 0.75), expected);
            let right = others.map(|y| -y);
            assert_eq!(only_on_wrong_side(points(right, false), -0.75), expected);
            // The same holds for pick-up points, except near the middle.
            assert_eq!(only_on_wrong_side(points(others, true), 0.75), expected);
            let near = others.map(|y| y / 5.0);
            assert_eq!(only_on_wrong_side(points(near, true), 0.75), None);
        }
    }
}
