//! The projection from space to the sheet.

use nalgebra::Vector3;

use super::pixels;
use crate::mechanism::{Axes, ends};

/// The direction from which a drawing shows the mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seen {
    /// From in front, outboard and above.
    Oblique,
    /// From in front.
    Front,
    /// From outboard; of an axle, from the left.
    Side,
    /// From above, x pointing down the sheet: below the front view, in its scale.
    Top,
}

impl Seen {
    /// All directions.
    pub const ALL: [Self; 4] = [Self::Oblique, Self::Front, Self::Side, Self::Top];

    /// Returns the title of the drawing; the oblique view has none. Outboard is to the left (1) or to the right (-1).
    fn title(self, outboard: f64) -> &'static str {
        match self {
            Self::Oblique => "",
            Self::Front => "from the front",
            Self::Side if outboard < 0.0 => "from the right",
            Self::Side => "from the left",
            Self::Top => "from above, forward down",
        }
    }

    /// The view that stands above or below this one on a sheet and must have the same scale.
    fn in_line(self) -> Self {
        match self {
            Self::Front => Self::Top,
            Self::Top => Self::Front,
            other => other,
        }
    }

    /// Returns the directions of space, in the axes of ISO 8855, that point right and up on the sheet; outboard is to the
    /// left (1) or to the right (-1).
    fn directions(self, outboard: f64) -> [Vector3<f64>; 2] {
        let directions = match self {
            Self::Oblique => {
                let (sa, ca) = (outboard * AZIMUTH).to_radians().sin_cos();
                let (se, ce) = ELEVATION.to_radians().sin_cos();
                [[-sa, ca, 0.0], [-se * ca, -se * sa, ce]]
            }
            Self::Front => [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            Self::Side => [[-outboard, 0.0, 0.0], [0.0, 0.0, 1.0]],
            Self::Top => [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]],
        };
        directions.map(Vector3::from)
    }
}

/// A parallel projection onto the sheet, in drawing units.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    pub(super) seen: Seen,
    pub(super) title: &'static str,
    pub(super) across: Vector3<f64>,
    pub(super) up: Vector3<f64>,
    /// Drawing units per unit of length.
    pub(super) scale: f64,
    /// The position of the origin of space.
    origin: [f64; 2],
}

/// The direction from which the oblique view looks: its angles from the x axis towards outboard, and above the ground,
/// degrees.
const AZIMUTH: f64 = 28.0;
const ELEVATION: f64 = 20.0;

impl View {
    /// Returns the projection that fits all points, given in these axes, with a margin; `None` if there are none.
    pub(super) fn fit(
        points: &[Vector3<f64>],
        axes: Axes,
        seen: Seen,
        (width, height): (u32, u32),
        margin: f64,
    ) -> Option<Self> {
        let outboard = outboard(points, axes);
        let projected = |seen: Seen| {
            let [across, up] = seen.directions(outboard).map(|way| axes.turned(way));
            let view = Self {
                seen,
                title: seen.title(outboard),
                across,
                up,
                scale: 1.0,
                origin: [0.0; 2],
            };
            let along = |axis: usize| ends(points.iter().map(|at| view.project(at)[axis]));
            Some((view, [along(0)?, along(1)?]))
        };
        let sheet = [f64::from(width), f64::from(height)];
        let span = |[low, high]: [f64; 2]| (high - low).max(f64::MIN_POSITIVE);
        let fit = |ends, size| (size - 2.0 * margin) / span(ends);
        let fitting = |[x, y]: [[f64; 2]; 2]| fit(x, sheet[0]).min(fit(y, sheet[1]));
        let (view, [x, y]) = projected(seen)?;
        let (_, in_line) = projected(seen.in_line())?;
        let scale = fitting([x, y]).min(fitting(in_line));
        let centred = |[low, high]: [f64; 2], size: f64| size / 2.0 - scale * (low + high) / 2.0;
        scale.is_finite().then_some(Self {
            scale,
            origin: [centred(x, sheet[0]), centred(y, sheet[1])],
            ..view
        })
    }

    /// Returns the position of a point on the sheet: to the right and down.
    pub(super) fn project(&self, at: &Vector3<f64>) -> [f64; 2] {
        [
            self.origin[0] + self.scale * self.across.dot(at),
            self.origin[1] - self.scale * self.up.dot(at),
        ]
    }

    pub(super) fn pixels(&self, at: &Vector3<f64>) -> (i32, i32) {
        pixels(self.project(at))
    }
}

/// Whether points in these axes are on the left (1) or the right (-1) of the vehicle. Points of both sides, as of an axle,
/// count as on the left.
fn outboard(points: &[Vector3<f64>], axes: Axes) -> f64 {
    let [_, to_the_left, _] = axes.signs();
    let (sum, sum_of_sizes) = points.iter().fold((0.0, 0.0), |(sum, sizes), at| {
        (sum + to_the_left * at.y, sizes + at.y.abs())
    });
    if sum < -0.5 * sum_of_sizes { -1.0 } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The points of both sides cancel out but for rounding, which must not choose the side of the view.
    #[test]
    fn an_axle_is_seen_from_the_left_and_a_corner_from_its_side() {
        let side = |y: [f64; 3]| {
            let points = y.map(|y| Vector3::new(0.1, y, y));
            let view = View::fit(&points, Axes::Iso, Seen::Side, (100, 100), 10.0);
            view.expect("points").title
        };
        for rounding in [-1e-12, 0.0, 1e-12] {
            assert_eq!(side([0.7, -0.7, rounding]), "from the left");
        }
        assert_eq!(side([0.7, 0.3, -0.1]), "from the left");
        assert_eq!(side([-0.7, -0.3, 0.1]), "from the right");
    }

    /// A point is below itself: in the views from the front and from above it is as far to the right.
    #[test]
    fn views_from_above_and_from_the_front_are_in_line() {
        for height in [0.1, 3.0] {
            let points = [[0.0, 0.3, 0.0], [1.0, 0.7, height]].map(Vector3::from);
            let across = [Seen::Front, Seen::Top].map(|seen| {
                let view = View::fit(&points, Axes::Iso, seen, (100, 100), 10.0);
                let view = view.expect("points");
                points.map(|at| view.project(&at)[0])
            });
            for (one, other) in across[0].iter().zip(across[1]) {
                assert!((one - other).abs() < 1e-9, "{across:?}");
            }
        }
    }

    #[test]
    fn views_project_z_upwards_and_outboard_to_the_right() {
        let points = [[0.0, 0.3, 0.1], [0.2, 0.7, 0.1], [0.0, 0.7, 0.5]].map(Vector3::from);
        for seen in [Seen::Oblique, Seen::Front] {
            let view = View::fit(&points, Axes::Iso, seen, (100, 100), 10.0).expect("points");
            let [low_inboard, low, high] = points.map(|at| view.project(&at));
            assert!(high[1] < low[1]);
            assert!(high[0] > low_inboard[0]);
            for at in [low_inboard, low, high] {
                assert!(at.iter().all(|x| (9.99..=90.01).contains(x)));
            }
        }
    }

    /// The side view of a wheel on the left shows the car driving to the left.
    #[test]
    fn right_up_and_view_direction_are_right_handed() {
        for (seen, outboard, eye) in [
            (Seen::Front, 1.0, [1.0, 0.0, 0.0]),
            (Seen::Side, 1.0, [0.0, 1.0, 0.0]),
            (Seen::Side, -1.0, [0.0, -1.0, 0.0]),
            (Seen::Top, 1.0, [0.0, 0.0, 1.0]),
        ] {
            let [a, b] = seen.directions(outboard);
            assert_eq!(a.cross(&b), Vector3::from(eye), "{seen:?}");
        }
    }
}
