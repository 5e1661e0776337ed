//! From space to the sheet.

/// A parallel projection onto the sheet, in its units, seen from in front, outboard and above.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    across: [f64; 3],
    up: [f64; 3],
    scale: f64,
    /// Where the origin of space is.
    origin: [f64; 2],
}

/// Of the direction to the eye: from the x axis towards outboard, and above the ground, degrees.
const AZIMUTH: f64 = 28.0;
const ELEVATION: f64 = 20.0;

impl View {
    /// Holds all points, with a margin; `None` where there are none.
    pub(super) fn around(
        points: &[[f64; 3]],
        (width, height): (u32, u32),
        margin: f64,
    ) -> Option<Self> {
        let outboard = points.iter().map(|at| at[1]).sum::<f64>();
        let azimuth = if outboard < 0.0 { -AZIMUTH } else { AZIMUTH };
        let (sa, ca) = azimuth.to_radians().sin_cos();
        let (se, ce) = ELEVATION.to_radians().sin_cos();
        let view = Self {
            across: [-sa, ca, 0.0],
            up: [-se * ca, -se * sa, ce],
            scale: 1.0,
            origin: [0.0; 2],
        };
        let flat: Vec<[f64; 2]> = points.iter().map(|at| view.of(*at)).collect();
        let ends = |axis: usize| {
            let values = flat.iter().map(|at| at[axis]);
            let low = values.clone().reduce(f64::min)?;
            Some([low, values.reduce(f64::max)?])
        };
        let (x, y) = (ends(0)?, ends(1)?);
        let sheet = [f64::from(width), f64::from(height)];
        let span = |[low, high]: [f64; 2]| (high - low).max(f64::MIN_POSITIVE);
        let fit = |ends, size| (size - 2.0 * margin) / span(ends);
        let scale = fit(x, sheet[0]).min(fit(y, sheet[1]));
        let centred = |[low, high]: [f64; 2], size: f64| size / 2.0 - scale * (low + high) / 2.0;
        scale.is_finite().then_some(Self {
            scale,
            origin: [centred(x, sheet[0]), centred(y, sheet[1])],
            ..view
        })
    }

    /// Where a point is on the sheet: to the right and down.
    pub(super) fn of(&self, at: [f64; 3]) -> [f64; 2] {
        let along = |axis: [f64; 3]| axis.iter().zip(at).map(|(a, x)| a * x).sum::<f64>();
        [
            self.origin[0] + self.scale * along(self.across),
            self.origin[1] - self.scale * along(self.up),
        ]
    }
}

/// Two directions of unit length square to an axis and to each other.
pub(super) fn square_to(axis: [f64; 3]) -> [[f64; 3]; 2] {
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

/// The convex hull, in order round it (Andrew's monotone chain).
pub(super) fn hull(mut points: Vec<(i32, i32)>) -> Vec<(i32, i32)> {
    points.sort_unstable();
    points.dedup();
    let mut hull = Vec::new();
    for mut side in [chain(points.iter()), chain(points.iter().rev())] {
        // Its last point is the first of the other side.
        side.pop();
        hull.append(&mut side);
    }
    if hull.is_empty() { points } else { hull }
}

/// One side of the hull, from the first point to the last.
fn chain<'a>(points: impl Iterator<Item = &'a (i32, i32)>) -> Vec<(i32, i32)> {
    let mut chain: Vec<(i32, i32)> = Vec::new();
    for &point in points {
        while let [.., a, b] = chain.as_slice() {
            if turn(*a, *b, point) > 0 {
                break;
            }
            chain.pop();
        }
        chain.push(point);
    }
    chain
}

/// Twice the area of a triangle, positive where it turns left.
fn turn(a: (i32, i32), b: (i32, i32), c: (i32, i32)) -> i64 {
    let along = |p: (i32, i32), q: (i32, i32)| (i64::from(q.0 - p.0), i64::from(q.1 - p.1));
    let ((ux, uy), (vx, vy)) = (along(a, b), along(a, c));
    ux * vy - uy * vx
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hull_leaves_inner_points_out() {
        let corners = vec![(0, 0), (4, 0), (4, 4), (0, 4)];
        let mut all = corners.clone();
        all.extend([(2, 2), (2, 0), (1, 3)]);
        assert_eq!(hull(all), corners);
    }

    #[test]
    fn up_is_up_and_outboard_is_on_the_right() {
        let points = [[0.0, 0.3, 0.1], [0.2, 0.7, 0.1], [0.0, 0.7, 0.5]];
        let view = View::around(&points, (100, 100), 10.0).expect("points");
        assert!(view.of(points[2])[1] < view.of(points[1])[1]);
        assert!(view.of(points[2])[0] > view.of(points[0])[0]);
        for at in points {
            assert!(view.of(at).iter().all(|x| (9.99..=90.01).contains(x)));
        }
    }
}
