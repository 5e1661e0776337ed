//! The extent of numbers and of points.

use nalgebra::Vector3;

/// The least and the greatest of numbers; `None` without any.
pub fn ends(numbers: impl IntoIterator<Item = f64>) -> Option<[f64; 2]> {
    let each = numbers.into_iter().map(|number| [number; 2]);
    each.reduce(|[least, greatest], [number, _]| [least.min(number), greatest.max(number)])
}

/// The sides of the box around points, along the axes; zero without points.
pub fn extent(points: impl IntoIterator<Item = Vector3<f64>>) -> Vector3<f64> {
    let corners = points.into_iter().map(|at| (at, at));
    let corners = corners.reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)));
    corners.map_or_else(Vector3::zeros, |(low, high)| high - low)
}
