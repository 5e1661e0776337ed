//! The points of a mechanism, for any linkage.

use std::rc::Rc;

use nalgebra::Vector3;

/// All points in a list, or their rates, shared by states about one place.
pub type Points = Rc<[Vector3<f64>]>;

/// The sides of the box around points, along the axes; zero without points.
pub fn extent(points: impl IntoIterator<Item = Vector3<f64>>) -> Vector3<f64> {
    let corners = points.into_iter().map(|at| (at, at));
    let corners = corners.reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)));
    corners.map_or_else(Vector3::zeros, |(low, high)| high - low)
}
