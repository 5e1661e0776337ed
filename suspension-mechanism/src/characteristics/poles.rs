//! Curves that pass through infinity or run towards it, as that of a swing arm where the carrier moves nearly parallel.

use crate::mechanism::ends;
use crate::quantities::{
    AXLE_ROLL_CENTRE, Column, FRONT_ARM, FRONT_CENTRE, Quantity, SIDE_ARM, SIDE_CENTRE,
};

/// Returns whether a quantity may have poles: an instant centre is at infinity if the carrier does not turn, the roll centre
/// if the normals of both wheels are parallel.
pub(super) fn has_poles(column: &Column) -> bool {
    const WITH_POLES: [&Quantity; 5] = [
        &FRONT_CENTRE,
        &FRONT_ARM,
        &SIDE_CENTRE,
        &SIDE_ARM,
        &AXLE_ROLL_CENTRE,
    ];
    WITH_POLES.iter().any(|quantity| column.is(quantity))
}

/// Removes the values that are infinite except for rounding, and those that exceed both 20 m and three times the median of
/// the curve: with them on its axis a chart would not show the others. `metre` is the length of a metre in the unit of the
/// values.
pub(super) fn remove_far(values: &[Option<f64>], metre: f64) -> Vec<Option<f64>> {
    const FAR: f64 = 20.0;
    const USUAL: f64 = 3.0;
    const INFINITE: f64 = 1e6;
    let sizes = values.iter().flatten().map(|value| value.abs());
    let mut sizes: Vec<f64> = sizes.filter(|size| *size < INFINITE * metre).collect();
    sizes.sort_by(f64::total_cmp);
    let median = sizes.get(sizes.len() / 2).copied().unwrap_or_default();
    let most = (FAR * metre).max(USUAL * median);
    let near = |value: &Option<f64>| value.filter(|value| value.abs() <= most);
    values.iter().map(near).collect()
}

/// Removes the values beside each place where a curve changes from one side of a pole to the other, so that both sides are
/// drawn; all values of a curve that jumps in many places, which is rounding.
pub(super) fn cut_at_jumps(values: &[Option<f64>]) -> Vec<Option<f64>> {
    /// The largest part of the values that poles may take.
    const MOST: f64 = 0.25;
    let mut cut = values.to_vec();
    while let Some(before) = widest_jump(&cut) {
        cut[before..=before + 1].fill(None);
    }
    let count = |values: &[Option<f64>]| values.iter().flatten().count() as f64;
    if count(&cut) < (1.0 - MOST) * count(values) {
        cut.fill(None);
    }
    cut
}

/// Returns the place before which a curve is on one side of a pole and behind which on the other: it changes there by a
/// large fraction of its range, and nowhere by more.
fn widest_jump(values: &[Option<f64>]) -> Option<usize> {
    const MUCH: f64 = 0.25;
    const ROUNDING: f64 = 1e-9;
    let [low, high] = ends(values.iter().flatten().copied())?;
    let whole = high - low;
    let pairs = values.windows(2).enumerate();
    let apart = |(before, pair): (usize, &[Option<f64>])| {
        let apart = (pair[0]? - pair[1]?).abs();
        Some((before, apart))
    };
    let widest = pairs.filter_map(apart).max_by(|a, b| a.1.total_cmp(&b.1));
    let is_constant = whole <= ROUNDING * high.abs().max(low.abs()).max(1.0);
    let (before, _) = widest.filter(|(_, apart)| !is_constant && *apart > MUCH * whole)?;
    Some(before)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A swing arm of 4 m at one end of the travel, whose carrier moves parallel at one sixth of it.
    #[test]
    fn a_curve_is_cut_at_its_pole_and_kept_on_both_sides() {
        let places = (0..61).map(|place| f64::from(place) - 10.5);
        let arm: Vec<_> = places.map(|place| Some(200.0 / place)).collect();
        assert_eq!(widest_jump(&arm), Some(10));
        let near = remove_far(&arm, 1.0);
        assert_eq!([near[10], near[11]], [None; 2]);
        assert_eq!([near[0], near[60]], [arm[0], arm[60]]);
        assert_eq!(cut_at_jumps(&near), near);
    }

    /// The same arm, a hundredth as long: none of its values is far.
    #[test]
    fn a_curve_with_a_pole_between_small_values_is_cut_beside_the_pole() {
        let places = (0..61).map(|place| f64::from(place) - 10.5);
        let arm: Vec<_> = places.map(|place| Some(2.0 / place)).collect();
        assert_eq!(remove_far(&arm, 1.0), arm);
        let cut = cut_at_jumps(&arm);
        assert_eq!([cut[10], cut[11]], [None; 2]);
        let others = [0..10, 12..61].map(|side| cut[side.clone()] == arm[side]);
        assert_eq!(others, [true; 2], "{cut:?}");
    }

    #[test]
    fn a_curve_of_rounding_errors_is_left_out() {
        let noise = (0..61).map(|place| f64::from(place * 37 % 61));
        let noise: Vec<_> = noise.map(Some).collect();
        assert_eq!(cut_at_jumps(&noise), vec![None; 61]);
    }

    #[test]
    fn a_curve_that_is_large_everywhere_is_kept() {
        let values: Vec<_> = (30..90).map(|value| Some(f64::from(value))).collect();
        assert_eq!(remove_far(&values, 1.0), values);
    }
}
