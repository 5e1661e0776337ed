//! Points that assembly puts elsewhere.

use nalgebra::Vector3;

use crate::kinematics::{Changes, Kinematics};

/// The points that are not where they were, or were moved to, when the mechanism with moved points is assembled: those points
/// do not satisfy the listing. None if it cannot be assembled.
pub fn misplaced_points(
    mechanism: &dyn Kinematics,
    points: Vec<(usize, Vector3<f64>)>,
) -> Vec<usize> {
    /// A fraction of their displacement.
    const OFF: f64 = 1e-3;
    /// A fraction of the largest coordinate.
    const ROUNDING: f64 = 1e-9;
    let before = mechanism.points();
    let mut moved = vec![Vector3::zeros(); before.len()];
    for (point, by) in &points {
        moved[*point] += by;
    }
    let lengths = Vec::new();
    let assembled = mechanism.changed(&Changes { points, lengths });
    let after = assembled.map_or_else(|_| Vec::new(), |mechanism| mechanism.points());
    let size = before
        .iter()
        .fold(0.0, |most, point| f64::max(most, point.amax()));
    let each = before.iter().zip(&after).zip(&moved).enumerate();
    let elsewhere = each.filter(|(_, ((before, after), by))| {
        let off = (*after - *before - *by).norm();
        off > (OFF * by.norm()).max(ROUNDING * size)
    });
    elsewhere.map(|(point, _)| point).collect()
}
