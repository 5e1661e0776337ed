//! A point on the wrong side of the vehicle.

/// How near to the middle of the vehicle a point is in it, as a part of the wheel's distance.
const MIDDLE: f64 = 1e-6;

/// Of points with their y the only one that is on the other side of the vehicle than a wheel's centre: its y has the
/// wrong sign, as it seems. Several may well be those of the other wheel.
pub fn only_on_wrong_side<T>(points: impl IntoIterator<Item = (T, f64)>, centre: f64) -> Option<T> {
    let across = |y: f64| y * centre < 0.0 && y.abs() > MIDDLE * centre.abs();
    let mut points = points.into_iter().filter(|(_, y)| across(*y));
    let (point, _) = points.next()?;
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
            assert_eq!(only_on_wrong_side((0..).zip(others), 0.75), expected);
            let right = others.map(|y| -y);
            assert_eq!(only_on_wrong_side((0..).zip(right), -0.75), expected);
        }
    }
}
