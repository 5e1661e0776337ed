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
    /// From outboard.
    Side,
    /// From above, x pointing down the sheet: below the front view.
    Top,
}

impl Seen {
    /// All directions.
    pub const ALL: [Self; 4] = [Self::Oblique, Self::Front, Self::Side, Self::Top];

    /// Returns the title of the drawing; the oblique view has none.
    pub(super) fn title(self) -> &'static str {
        match self {
            Self::Oblique => "",
            Self::Front => "from the front",
            Self::Side => "from the side",
            Self::Top => "from above, forward down",
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
        let [_, to_the_left, _] = axes.signs();
        let left = to_the_left * points.iter().map(|at| at.y).sum::<f64>();
        let directions = seen.directions(if left < 0.0 { -1.0 } else { 1.0 });
        let [across, up] = directions.map(|way| axes.turned(way));
        let view = Self {
            seen,
            across,
            up,
            scale: 1.0,
            origin: [0.0; 2],
        };
        let flat: Vec<[f64; 2]> = points.iter().map(|at| view.project(at)).collect();
        let along = |axis: usize| ends(flat.iter().map(|at| at[axis]));
        let (x, y) = (along(0)?, along(1)?);
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

#[cfg(test)]
mod tests {
    use super::*;

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
