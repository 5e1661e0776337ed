//! Measured numbers without their noise.

/// Returns the height at a place of the straight line through the points around it, the nearer ones with more weight; NaN
/// without points nearer than `reach`.
///
/// Unlike the mean of these points, it is right on a slope, and at the end of the range, where all are on one side.
pub(super) fn smoothed(points: impl Iterator<Item = (f64, f64)>, at: f64, reach: f64) -> f64 {
    /// Points that are nearer to each other, as a part of `reach`, are at one place.
    const ONE_PLACE: f64 = 1e-6;
    let near = points.filter_map(|(across, height)| {
        let from = across - at;
        // The place itself counts without any reach, too.
        let weight = if from == 0.0 {
            1.0
        } else {
            1.0 - from.abs() / reach
        };
        (weight > 0.0).then_some((weight, from, height))
    });
    let near: Vec<(f64, f64, f64)> = near.collect();
    let sum = |of: &dyn Fn(f64, f64) -> f64| -> f64 {
        near.iter()
            .map(|(weight, from, height)| weight * of(*from, *height))
            .sum()
    };
    let weight = sum(&|_, _| 1.0);
    let [from, height] = [sum(&|from, _| from), sum(&|_, height| height)].map(|sum| sum / weight);
    let [both, square] = [
        sum(&|x, y| (x - from) * (y - height)),
        sum(&|x, _| (x - from).powi(2)),
    ];
    match square > weight * (ONE_PLACE * reach).powi(2) {
        true => height - both / square * from,
        false => height,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_on_a_line_stay_there_also_beside_it_and_at_its_end() {
        let points = [-1.0, 0.5, 2.0, 2.5, 70.0].map(|at| (at, 3.0 - 2.0 * at));
        for (at, reach) in [(-1.0, 4.0), (1.0, 1.2), (2.0, 3.0), (2.5, 0.0)] {
            let found = smoothed(points.into_iter(), at, reach);
            assert!((found - 3.0 + 2.0 * at).abs() < 1e-14, "{at} {found}");
        }
        assert!(smoothed(points.into_iter(), 1.0, 0.2).is_nan());
    }

    /// Weights 1 twice and 0.5 on both sides; the fifth point is out of reach.
    #[test]
    fn heights_at_one_place_are_averaged_with_those_around() {
        let points = [
            (0.0, 1.0),
            (0.0, 3.0),
            (-1.0, 5.0),
            (1.0, 7.0),
            (2.0, 900.0),
        ];
        let found = smoothed(points.into_iter(), 0.0, 2.0);
        assert!((found - 10.0 / 3.0).abs() < 1e-14, "{found}");
    }
}
