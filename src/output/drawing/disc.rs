//! The rim of a wheel.

use super::Wheel;

/// Returns points along the rim of a wheel, closed, with all points at the coordinates `at`.
pub(super) fn rim(
    wheel: &Wheel,
    at: &[[f64; 3]],
) -> Option<impl Iterator<Item = [f64; 3]> + use<>> {
    const CORNERS: usize = 72;
    let [inner, centre] = wheel.axis;
    let (inner, centre, radius) = (*at.get(inner)?, *at.get(centre)?, wheel.radius);
    let [across, up] = square_to(std::array::from_fn(|i| centre[i] - inner[i]));
    Some((0..=CORNERS).map(move |corner| {
        let (sine, cosine) = (std::f64::consts::TAU * corner as f64 / CORNERS as f64).sin_cos();
        std::array::from_fn(|i| centre[i] + radius * (cosine * across[i] + sine * up[i]))
    }))
}

/// Returns two unit vectors perpendicular to an axis and to each other.
fn square_to(axis: [f64; 3]) -> [[f64; 3]; 2] {
    let least = if axis[2].abs() < 0.9 * norm(axis) {
        [0.0, 0.0, 1.0]
    } else {
        [1.0, 0.0, 0.0]
    };
    let across = unit(cross(axis, least));
    [across, unit(cross(axis, across))]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    })
}

fn norm(a: [f64; 3]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    a.map(|x| x / norm(a))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rim_is_as_far_from_the_centre_as_the_radius_says() {
        let points = [[0.0, 0.65, 0.30], [0.0, 0.75, 0.30]];
        let wheel = Wheel {
            axis: [0, 1],
            radius: 0.3,
            kingpin: None,
        };
        for at in rim(&wheel, &points).expect("a wheel") {
            let d: [f64; 3] = std::array::from_fn(|i| at[i] - points[1][i]);
            let square: f64 = d.iter().map(|x| x * x).sum();
            assert!((square.sqrt() - wheel.radius).abs() < 1e-12);
            assert!(d[1].abs() < 1e-12, "square to the axis");
        }
    }
}
