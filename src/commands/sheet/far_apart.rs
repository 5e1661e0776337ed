//! Curves of several wheels in one chart that lie far apart, such as those of y on both sides of the vehicle.

use crate::mechanism::ends;

/// The points of a curve; a missing one is NaN.
type Points = Vec<(f64, f64)>;

/// Returns whether curves are so far apart that they would look flat in one chart.
pub(super) fn are_far_apart(curves: &[Points]) -> bool {
    /// The height of the chart, in heights of the largest curve.
    const FLAT: f64 = 5.0;
    let heights = |curve: &Points| {
        let heights = curve.iter().map(|(_, height)| *height);
        heights
            .filter(|height| height.is_finite())
            .collect::<Vec<_>>()
    };
    let height = |heights: Vec<f64>| ends(heights).map_or(0.0, |[low, high]| high - low);
    let largest = curves.iter().map(|curve| height(heights(curve)));
    let largest = largest.fold(0.0, f64::max);
    let all = height(curves.iter().flat_map(heights).collect());
    largest > 0.0 && all > FLAT * largest
}

/// Returns curves, each as its change from a value of its own.
pub(super) fn changes_from(curves: Vec<Points>, values: &[f64]) -> Vec<Points> {
    let each = curves.into_iter().zip(values);
    let lowered = |(curve, value): (Points, &f64)| {
        let points = curve.into_iter();
        points.map(|(across, up)| (across, up - value)).collect()
    };
    each.map(lowered).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_of_both_sides_are_shown_by_their_change() {
        let curve = |from: f64, to: f64| vec![(0.0, from), (1.0, f64::NAN), (2.0, to)];
        let sides = vec![curve(600.0, 610.0), curve(-600.0, -590.0)];
        assert!(are_far_apart(&sides));
        for change in changes_from(sides, &[600.0, -600.0]) {
            assert_eq!((change[0], change[2]), ((0.0, 0.0), (2.0, 10.0)));
        }
        assert!(!are_far_apart(&[curve(0.0, 10.0), curve(0.0, -10.0)]));
        assert!(
            !are_far_apart(&[curve(5.0, 5.0), curve(-5.0, -5.0)]),
            "constants"
        );
        assert!(!are_far_apart(&[curve(600.0, 610.0)]));
    }
}
