//! A drawing of a linkage as SVG: chassis points, links, slides, bodies, measured lengths and the wheel.

mod labels;
mod start;
mod view;

use plotters::element::DashedPathElement;
use plotters::prelude::*;

use labels::{Boxed, Labels};
pub use start::drawing_of;
use view::View;

/// What there is to draw. Points in axes of ISO 8855: x forward, y left, z up.
#[derive(Clone, Debug, Default)]
pub struct Drawing {
    /// Names and positions.
    pub points: Vec<(String, [f64; 3])>,
    /// How many of them, the first ones, are on the chassis.
    pub chassis: usize,
    /// Links: each joins two points, by their indices.
    pub links: Vec<[usize; 2]>,
    /// Slides: the ends of each line and the point on it, by their indices.
    pub slides: Vec<[usize; 3]>,
    /// Measured lengths, springs and dampers among them: the ends of each, by their indices.
    pub lengths: Vec<[usize; 2]>,
    /// Bodies: the points of each, by their indices.
    pub bodies: Vec<Vec<usize>>,
    /// The wheel.
    pub wheel: Option<Disc>,
}

/// A wheel: a circle about its centre, square to its axis.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    /// The wheel centre.
    pub centre: [f64; 3],
    /// The direction of the spin axis.
    pub axis: [f64; 3],
    /// The radius, in the unit of the points.
    pub radius: f64,
}

/// Width and height as shown.
const SIZE: (u32, u32) = (900, 640);
/// Drawing units to one of those: plotters rounds to whole units.
const FINE: u32 = 8;
const MARGIN: f64 = 70.0;
const FONT_SIZE: u32 = 14;

const CHASSIS: RGBColor = RGBColor(60, 60, 60);
const LINK: RGBColor = RGBColor(31, 90, 160);
const BODY: RGBColor = RGBColor(200, 80, 20);
const LENGTH: RGBColor = RGBColor(40, 130, 70);
const TYRE: RGBColor = RGBColor(120, 120, 120);

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;
type Drawn = Result<(), Box<dyn std::error::Error>>;

impl Drawing {
    /// The drawing as an SVG document; `None` where there are no points.
    pub fn svg(&self) -> Option<String> {
        let view = View::around(&self.outline(), SIZE, MARGIN)?;
        let mut text = String::new();
        let size = (SIZE.0 * FINE, SIZE.1 * FINE);
        let area = SVGBackend::with_string(&mut text, size).into_drawing_area();
        // Drawing into memory has no way to fail but a mistake in this file.
        self.draw(&area, &view).ok()?;
        drop(area);
        let drawn = format!("width=\"{}\" height=\"{}\"", size.0, size.1);
        let shown = format!("width=\"{}\" height=\"{}\"", SIZE.0, SIZE.1);
        Some(text.replacen(&drawn, &shown, 1))
    }

    fn draw(&self, area: &Area<'_>, view: &View) -> Drawn {
        area.fill(&WHITE)?;
        let at = |index: &usize| self.points.get(*index).map(|(_, at)| pixels(view.of(*at)));
        if let Some(disc) = &self.wheel {
            let rim: Vec<_> = disc.rim().map(|at| pixels(view.of(at))).collect();
            area.draw(&Polygon::new(rim.clone(), TYRE.mix(0.12).filled()))?;
            area.draw(&PathElement::new(rim, TYRE.stroke_width(2 * FINE)))?;
        }
        for body in &self.bodies {
            let corners: Vec<_> = body.iter().filter_map(at).collect();
            let hull = view::hull(corners);
            area.draw(&Polygon::new(hull.clone(), BODY.mix(0.22).filled()))?;
            let closed = hull.iter().chain(hull.first()).copied();
            area.draw(&PathElement::new(
                closed.collect::<Vec<_>>(),
                BODY.stroke_width(FINE),
            ))?;
        }
        self.draw_lines(area, view)?;
        self.draw_points(area, view)?;
        area.present()?;
        Ok(())
    }

    fn draw_lines(&self, area: &Area<'_>, view: &View) -> Drawn {
        let at = |index: &usize| self.points.get(*index).map(|(_, at)| pixels(view.of(*at)));
        for line in &self.lengths {
            let ends = line.iter().filter_map(at);
            let (dash, gap) = (9 * FINE, 5 * FINE);
            let stroke = LENGTH.stroke_width(2 * FINE);
            area.draw(&DashedPathElement::new(ends, dash, gap, stroke))?;
        }
        for slide in &self.slides {
            let line: Vec<_> = slide.iter().filter_map(at).collect();
            area.draw(&PathElement::new(line, LINK.stroke_width(2 * FINE)))?;
        }
        for link in &self.links {
            let ends: Vec<_> = link.iter().filter_map(at).collect();
            area.draw(&PathElement::new(ends, LINK.stroke_width(4 * FINE)))?;
        }
        Ok(())
    }

    fn draw_points(&self, area: &Area<'_>, view: &View) -> Drawn {
        let places: Vec<(i32, i32)> = self
            .points
            .iter()
            .map(|(_, at)| pixels(view.of(*at)))
            .collect();
        for (index, &(x, y)) in places.iter().enumerate() {
            let half = 5 * FINE as i32;
            if index < self.chassis {
                let corners = [(x - half, y - half), (x + half, y + half)];
                area.draw(&Rectangle::new(corners, CHASSIS.filled()))?;
            } else {
                area.draw(&Circle::new((x, y), half, WHITE.filled()))?;
                area.draw(&Circle::new((x, y), half, LINK.stroke_width(2 * FINE)))?;
            }
        }
        let mut labels = Labels::among(&places, SIZE, FINE as i32);
        for ((name, _), place) in self.points.iter().zip(&places) {
            let Boxed { left, top } = labels.put(name, *place);
            let style = ("sans-serif", FONT_SIZE * FINE).into_font().color(&CHASSIS);
            area.draw(&Text::new(name.as_str(), (left, top), style))?;
        }
        Ok(())
    }

    /// All that the picture must hold.
    fn outline(&self) -> Vec<[f64; 3]> {
        let points = self.points.iter().map(|(_, at)| *at);
        points
            .chain(self.wheel.iter().flat_map(Disc::rim))
            .collect()
    }
}

impl Disc {
    /// Points along the rim, the first one again at the end.
    fn rim(&self) -> impl Iterator<Item = [f64; 3]> {
        const CORNERS: usize = 72;
        let [across, up] = view::square_to(self.axis);
        let Self { centre, radius, .. } = *self;
        (0..=CORNERS).map(move |corner| {
            let (sine, cosine) = (std::f64::consts::TAU * corner as f64 / CORNERS as f64).sin_cos();
            std::array::from_fn(|i| centre[i] + radius * (cosine * across[i] + sine * up[i]))
        })
    }
}

fn pixels([x, y]: [f64; 2]) -> (i32, i32) {
    let fine = f64::from(FINE);
    ((x * fine).round() as i32, (y * fine).round() as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corner() -> Drawing {
        let points = [
            ("lower_front", [0.2, 0.35, 0.16]),
            ("lower_rear", [-0.2, 0.35, 0.16]),
            ("lower_ball", [0.0, 0.70, 0.17]),
            ("upper_ball", [-0.01, 0.66, 0.44]),
        ];
        Drawing {
            points: points.map(|(name, at)| (name.to_owned(), at)).to_vec(),
            chassis: 2,
            links: vec![[0, 2], [1, 2]],
            slides: vec![[2, 3, 0]],
            lengths: vec![[1, 3]],
            bodies: vec![vec![2, 3, 1]],
            wheel: Some(Disc {
                centre: [0.0, 0.75, 0.30],
                axis: [0.0, 1.0, 0.0],
                radius: 0.3,
            }),
        }
    }

    #[test]
    fn names_each_point_once() {
        let svg = corner().svg().expect("points");
        for (name, _) in corner().points {
            assert_eq!(svg.matches(&name).count(), 1, "{name}");
        }
        assert_eq!(
            svg.matches("<rect").count(),
            1 + 2,
            "background and two chassis points"
        );
    }

    #[test]
    fn measured_lengths_are_dashed() {
        let solid = Drawing {
            lengths: Vec::new(),
            ..corner()
        };
        let lines = |drawing: &Drawing| drawing.svg().expect("points").matches("<polyline").count();
        assert!(lines(&corner()) > lines(&solid) + 5);
    }

    #[test]
    fn the_rim_is_as_far_from_the_centre_as_the_radius_says() {
        let disc = corner().wheel.expect("a wheel");
        for at in disc.rim() {
            let d: [f64; 3] = std::array::from_fn(|i| at[i] - disc.centre[i]);
            let square: f64 = d.iter().map(|x| x * x).sum();
            assert!((square.sqrt() - disc.radius).abs() < 1e-12);
            assert!(d[1].abs() < 1e-12, "square to the axis");
        }
    }

    #[test]
    fn without_points_there_is_no_drawing() {
        assert!(Drawing::default().svg().is_none());
    }
}
