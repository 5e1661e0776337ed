//! The outline of a body.

/// Returns the convex hull, in order round it (Andrew's monotone chain).
pub(super) fn hull(mut points: Vec<(i32, i32)>) -> Vec<(i32, i32)> {
    points.sort_unstable();
    points.dedup();
    let mut hull = Vec::new();
    for mut side in [chain(points.iter()), chain(points.iter().rev())] {
        // The last point of a side is the first of the other.
        side.pop();
        hull.append(&mut side);
    }
    if hull.is_empty() { points } else { hull }
}

/// Returns one side of the hull, from the first point to the last.
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

/// Returns twice the area of a triangle, positive if it turns left.
fn turn(a: (i32, i32), b: (i32, i32), c: (i32, i32)) -> i64 {
    let along = |p: (i32, i32), q: (i32, i32)| (i64::from(q.0 - p.0), i64::from(q.1 - p.1));
    let ((ux, uy), (vx, vy)) = (along(a, b), along(a, c));
    ux * vy - uy * vx
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_convex_hull_omits_inner_points() {
        let corners = vec![(0, 0), (4, 0), (4, 4), (0, 4)];
        let mut all = corners.clone();
        all.extend([(2, 2), (2, 0), (1, 3)]);
        assert_eq!(hull(all), corners);
    }
}
