//! Recorded values, with a smooth curve through them.

/// The cubic spline through points in the order of time, with continuous second derivatives. Its third derivative is
/// continuous at the second point and the last but one ("not-a-knot"; C. de Boor 1978, A Practical Guide to Splines, chapter IV).
#[derive(Clone, Debug)]
pub struct Spline {
    /// Time and value.
    points: Vec<[f64; 2]>,
    /// At each point.
    second_derivatives: Vec<f64>,
}

impl Spline {
    /// The curve through points of increasing time; `None` for fewer than two points or another order.
    pub fn through(points: Vec<[f64; 2]>) -> Option<Self> {
        let in_order = points.windows(2).all(|two| two[0][0] < two[1][0]);
        (points.len() >= 2 && in_order).then(|| Self {
            second_derivatives: second_derivatives(&points),
            points,
        })
    }

    /// The first and the last time.
    pub fn ends(&self) -> [f64; 2] {
        [self.points[0][0], self.points[self.points.len() - 1][0]]
    }

    /// The derivative of the given order at time `t`, the value itself for order 0; beyond the ends that of the piece at the end.
    pub(super) fn derivative(&self, order: u8, t: f64) -> f64 {
        let after = self.points.partition_point(|[time, _]| *time <= t);
        let after = after.clamp(1, self.points.len() - 1);
        let [[start, from], [end, to]] = [self.points[after - 1], self.points[after]];
        let [second, second_after] = [after - 1, after].map(|at| self.second_derivatives[at]);
        let width = end - start;
        let (left, right) = ((end - t) / width, (t - start) / width);
        match order {
            0 => {
                let cubic = |x: f64| x * x * x - x;
                let curved = cubic(left) * second + cubic(right) * second_after;
                left * from + right * to + curved * width * width / 6.0
            }
            1 => {
                let square = |x: f64| 3.0 * x * x - 1.0;
                let curved = square(right) * second_after - square(left) * second;
                (to - from) / width + curved * width / 6.0
            }
            2 => left * second + right * second_after,
            3 => (second_after - second) / width,
            _ => 0.0,
        }
    }
}

fn second_derivatives(points: &[[f64; 2]]) -> Vec<f64> {
    let widths: Vec<f64> = points.windows(2).map(|two| two[1][0] - two[0][0]).collect();
    let slopes = points.windows(2).zip(&widths);
    let slopes: Vec<f64> = slopes
        .map(|(two, width)| (two[1][1] - two[0][1]) / width)
        .collect();
    let last = widths.len() - 1;
    if last == 0 {
        return vec![0.0; 2];
    }
    if last == 1 {
        return vec![2.0 * (slopes[1] - slopes[0]) / (widths[0] + widths[1]); 3];
    }
    // The rows of the inner points, with the unknowns at both ends expressed by their neighbours.
    let mut rows: Vec<[f64; 4]> = (1..=last)
        .map(|at| {
            let [before, after] = [widths[at - 1], widths[at]];
            [
                before,
                2.0 * (before + after),
                after,
                6.0 * (slopes[at] - slopes[at - 1]),
            ]
        })
        .collect();
    let [first, end] = [widths[0] / widths[1], widths[last] / widths[last - 1]];
    rows[0][1] += widths[0] * (1.0 + first);
    rows[0][2] -= widths[0] * first;
    rows[last - 1][1] += widths[last] * (1.0 + end);
    rows[last - 1][0] -= widths[last] * end;
    let inner = tridiagonal(rows);
    let mut all = vec![(1.0 + first) * inner[0] - first * inner[1]];
    all.extend(&inner);
    all.push((1.0 + end) * inner[last - 1] - end * inner[last - 2]);
    all
}

/// The solution of rows of `[before, diagonal, after, right]`, by elimination without pivoting: the diagonal dominates.
fn tridiagonal(mut rows: Vec<[f64; 4]>) -> Vec<f64> {
    for row in 1..rows.len() {
        let [_, diagonal, after, right] = rows[row - 1];
        let factor = rows[row][0] / diagonal;
        rows[row][1] -= factor * after;
        rows[row][3] -= factor * right;
    }
    let mut solution = vec![0.0; rows.len() + 1];
    for (row, [_, diagonal, after, right]) in rows.iter().enumerate().rev() {
        solution[row] = (right - after * solution[row + 1]) / diagonal;
    }
    solution.truncate(rows.len());
    solution
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At uneven times.
    fn sampled(of: impl Fn(f64) -> f64, count: usize) -> Spline {
        let time = |k: usize| 0.1 * k as f64 + 0.02 * (k as f64).sin();
        Spline::through((0..count).map(|k| [time(k), of(time(k))]).collect()).expect("in order")
    }

    #[test]
    fn a_cubic_is_reproduced_with_its_derivatives() {
        let spline = sampled(|t| 1.0 - 2.0 * t + 3.0 * t * t - 4.0 * t * t * t, 9);
        for t in [-0.01, 0.0, 0.05, 0.37, 0.8, 0.9] {
            let expected = [
                1.0 - 2.0 * t + 3.0 * t * t - 4.0 * t * t * t,
                -2.0 + 6.0 * t - 12.0 * t * t,
                6.0 - 24.0 * t,
                -24.0,
                0.0,
            ];
            for (order, expected) in (0..).zip(expected) {
                let found = spline.derivative(order, t);
                assert!((found - expected).abs() < 1e-11, "{order} at {t}: {found}");
            }
        }
    }

    #[test]
    fn two_points_are_a_line_and_three_a_parabola() {
        let line = sampled(|t| 1.0 + t, 2);
        assert!((line.derivative(0, 0.07) - 1.07).abs() < 1e-15);
        let parabola = sampled(|t| t * t, 3);
        assert!((parabola.derivative(0, 0.07) - 0.0049).abs() < 1e-16);
        assert!((parabola.derivative(2, 0.07) - 2.0).abs() < 1e-13);
    }

    /// The values are those of `scipy.interpolate.CubicSpline`, version 1.17.1, of which the third derivative at a point is that
    /// of the piece behind it, as here.
    #[test]
    fn the_curve_is_that_of_scipy() {
        let times = [0.0, 0.1, 0.25, 0.3, 0.55, 0.8, 1.0];
        let values = [0.30, 0.31, 0.27, 0.28, 0.33, 0.29, 0.30];
        let points = times.into_iter().zip(values);
        let spline = Spline::through(points.map(<[f64; 2]>::from).collect()).expect("in order");
        for (t, expected) in [
            (
                0.0,
                [
                    0.3,
                    0.6070126582278483,
                    -13.023021097046417,
                    86.48303797468358,
                ],
            ),
            (
                0.07,
                [
                    0.31552843139240505,
                    -0.09271537552742615,
                    -6.969208438818566,
                    86.48303797468358,
                ],
            ),
            (
                0.27,
                [
                    0.2725764475949367,
                    0.19278511392405098,
                    5.295540928270038,
                    -165.10987341772167,
                ],
            ),
            (
                0.6,
                [
                    0.32725981434599155,
                    -0.10591898734177221,
                    -1.7964489451476795,
                    14.88972151898734,
                ],
            ),
            (
                0.97,
                [
                    0.2908043694177215,
                    0.24859634092827007,
                    3.7127480168776392,
                    14.88972151898735,
                ],
            ),
        ] {
            for (order, expected) in (0..).zip(expected) {
                let found = spline.derivative(order, t);
                assert!(
                    (found - expected).abs() < 1e-12 * expected.abs(),
                    "{order} at {t}: {found}"
                );
            }
        }
    }

    #[test]
    fn times_must_increase() {
        assert!(Spline::through(vec![[0.0, 1.0]]).is_none());
        assert!(Spline::through(vec![[0.0, 1.0], [0.0, 2.0]]).is_none());
        assert!(Spline::through(vec![[0.0, 1.0], [f64::NAN, 2.0]]).is_none());
    }
}
