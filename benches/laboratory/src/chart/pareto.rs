//! The Pareto front: methods that no other method beats in both time and accuracy.

/// Returns the indices of the points that no other point equals or beats in both coordinates, sorted by the first
/// coordinate. Of equal points only the first counts.
pub fn front(points: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|a, b| {
        let ((x, y), (other_x, other_y)) = (points[*a], points[*b]);
        x.total_cmp(&other_x).then(y.total_cmp(&other_y))
    });
    let mut best = f64::INFINITY;
    order.retain(|index| {
        let (_, y) = points[*index];
        let is_better = y < best;
        best = best.min(y);
        is_better
    });
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pareto_front_has_each_undominated_method_once() {
        let points = [
            (5.0, 1.0),
            (1.0, 5.0),
            (2.0, 6.0),
            (3.0, 3.0),
            (3.0, 3.0),
            (4.0, f64::NAN),
            (6.0, 1.0),
            (3.0, 4.0),
        ];
        assert_eq!(front(&points), [1, 3, 0]);
        assert_eq!(front(&[]), [0; 0]);
    }
}
