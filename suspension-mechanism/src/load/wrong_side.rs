//! A point on the wrong side of the vehicle.

/// How near to the middle of the vehicle a point is in it, as a part of the wheel's distance.
const MIDDLE: f64 = 1e-6;

/// The same of a pick-up point: those of dampers and the like may well be a little beyond the middle.
const MIDDLE_OF_PICK_UPS: f64 = 0.2;

/// Of points with their y, and whether they are pick-up points on the chassis, the only one that is on the other side of the
/// vehicle than a wheel's centre: its y has the wrong sign, as it seems. Several may well be those of the other wheel.
pub fn only_on_wrong_side<T>(
    points: impl IntoIterator<Item = (T, f64, bool)>,
    centre: f64,
) -> Option<T> {
    let across = |y: f64, is_pick_up: bool| {
        let middle = if is_pick_up {
            MIDDLE_OF_PICK_UPS
        } else {
            MIDDLE
        };
        y * centre < 0.0 && y.abs() > middle * centre.abs()
    };
    let points = points.into_iter();
    let mut points = points.filter(|(_, y, is_pick_up)| across(*y, *is_pick_up));
    let (point, ..) = points.next()?;
    points.next().is_none().then_some(point)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_point_beyond_the_middle_is_told_and_several_are_not() {
        for (others, expected) in [
            ([0.7, 0.6, 0.1], None),
            ([0.7, -0.6, 0.1], Some(1)),
            ([0.7, -1e-12, 0.1], None),
            ([-0.7, -0.6, 0.1], None),
        ] {
            let of = |y: [f64; 3], pick_up| (0..).zip(y).map(move |(point, y)| (point, y, pick_up));
            assert_eq!(only_on_wrong_side(of(others, false), 0.75), expected);
            let right = others.map(|y| -y);
            assert_eq!(only_on_wrong_side(of(right, false), -0.75), expected);
            // Of pick-up points the same, but for what is near the middle.
            assert_eq!(only_on_wrong_side(of(others, true), 0.75), expected);
            let near = others.map(|y| y / 5.0);
            assert_eq!(only_on_wrong_side(of(near, true), 0.75), None);
        }
    }
}
