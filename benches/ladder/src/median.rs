//! The middle of repeated measurements.

pub(crate) fn median<const K: usize>(mut values: [f64; K]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[K / 2]
}
