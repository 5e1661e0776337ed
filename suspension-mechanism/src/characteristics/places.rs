//! The places of a curve.

use crate::mechanism::evenly_spaced;

/// `count` changes from the design position, evenly spaced from the first to the last, except that one of them is the design
/// position itself if this is between the ends: curves are read there, and cross zero where they count from it.
pub fn through_design([from, to]: [f64; 2], count: usize) -> Vec<f64> {
    let mut changes = evenly_spaced([from, to], count);
    if from < 0.0 && to > 0.0 {
        let inner = changes.iter_mut().skip(1).take(count.saturating_sub(2));
        let nearest = inner.min_by(|a, b| a.abs().total_cmp(&b.abs()));
        nearest.into_iter().for_each(|change| *change = 0.0);
    }
    changes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_place_is_the_design_position_and_the_order_stays() {
        for ends in [[-80.0, 130.0], [-0.1, 50.0], [-50.0, 1e-9], [-60.0, 60.0]] {
            let changes = through_design(ends, 61);
            assert_eq!((changes.len(), [changes[0], changes[60]]), (61, ends));
            assert!(changes.contains(&0.0), "{changes:?}");
            assert!(changes.is_sorted_by(|a, b| a < b), "{changes:?}");
        }
        assert_eq!(
            through_design([10.0, 50.0], 61),
            evenly_spaced([10.0, 50.0], 61)
        );
    }
}
