//! The rim of a wheel.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use super::Wheel;

/// Returns points along the rim of a wheel, closed, with all points at the coordinates `at`.
pub(super) fn rim(
    wheel: &Wheel,
    at: &[Vector3<f64>],
) -> Option<impl Iterator<Item = Vector3<f64>> + use<>> {
    const CORNERS: usize = 72;
    let [inner, centre] = wheel.axis;
    let (inner, centre, radius) = (*at.get(inner)?, *at.get(centre)?, wheel.radius);
    let [across, up] = perpendicular_to(centre - inner);
    // Arrays, because operators of vectors are slow in code that is not optimised, as this crate's.
    let [centre, across, up]: [[f64; 3]; 3] = [centre, across, up].map(Into::into);
    Some((0..=CORNERS).map(move |corner| {
        let (sine, cosine) = (TAU * corner as f64 / CORNERS as f64).sin_cos();
        let at = |axis: usize| centre[axis] + radius * (cosine * across[axis] + sine * up[axis]);
        Vector3::new(at(0), at(1), at(2))
    }))
}

/// Returns two unit vectors perpendicular to an axis and to each other.
fn perpendicular_to(axis: Vector3<f64>) -> [Vector3<f64>; 2] {
    let is_upright = axis.z.abs() >= 0.9 * axis.norm();
    let other = if is_upright {
        Vector3::x()
    } else {
        Vector3::z()
    };
    let across = axis.cross(&other).normalize();
    [across, axis.cross(&across).normalize()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_drawn_rim_has_the_wheel_radius_about_the_centre() {
        let points = [[0.0, 0.65, 0.30], [0.0, 0.75, 0.30]].map(Vector3::from);
        let wheel = Wheel {
            axis: [0, 1],
            radius: 0.3,
            kingpin: None,
        };
        for at in rim(&wheel, &points).expect("a wheel") {
            let off = at - points[1];
            assert!((off.norm() - wheel.radius).abs() < 1e-12);
            assert!(off.y.abs() < 1e-12, "perpendicular to the axis");
        }
    }
}
