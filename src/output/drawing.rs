//! A drawing of a linkage as SVG: chassis points, links, slides, bodies, driven and measured lengths, the wheels and their axes.

mod axes;
mod disc;
mod forces;
mod hull;
mod labels;
mod shared_labels;
mod start;
#[cfg(test)]
mod tests;
mod view;

use nalgebra::Vector3;
use plotters::element::DashedPathElement;
use plotters::prelude::*;

use crate::mechanism::Axes;
use crate::output::svg::{Area, Drawn, FINE, document};
use disc::rim;
use forces::put;
pub use forces::{Acting, Forces, InLink};
use labels::{Labels, Segment};
pub use start::drawing_of;
pub use view::Seen;
use view::View;

/// The contents of a drawing.
#[derive(Clone, Debug, Default)]
pub struct Drawing {
    /// The names of the points.
    pub names: Vec<String>,
    /// Their positions.
    pub points: Vec<Vector3<f64>>,
    /// The axes of all positions.
    pub axes: Axes,
    /// The number of chassis points, which come first.
    pub chassis: usize,
    /// Links: each joins two points, by their indices.
    pub links: Vec<[usize; 2]>,
    /// Slides: the ends of each line and the point on it, by their indices.
    pub slides: Vec<[usize; 3]>,
    /// Measured lengths, springs and dampers among them: the ends of each, by their indices.
    pub lengths: Vec<[usize; 2]>,
    /// Bodies: the points of each, by their indices.
    pub bodies: Vec<Vec<usize>>,
    /// The wheels.
    pub wheels: Vec<Wheel>,
    /// All points at other places of the motion, which are drawn faintly.
    pub others: Vec<Vec<Vector3<f64>>>,
    /// Loads and the forces in links, if the drawing shows them.
    pub forces: Option<Forces>,
    /// The symbol of the unit of lengths.
    pub unit: &'static str,
}

/// A wheel: a circle about its centre, perpendicular to the spin axis.
#[derive(Clone, Copy, Debug)]
pub struct Wheel {
    /// The ends of the spin axis, by their indices, the wheel centre last.
    pub axis: [usize; 2],
    /// The kingpin's ends, by their indices.
    pub kingpin: Option<[usize; 2]>,
    /// The radius, in the unit of the points.
    pub radius: f64,
}

/// Width and height in pixels.
pub const SIZE: (u32, u32) = (900, 640);
const MARGIN: f64 = 70.0;
const FONT_SIZE: u32 = 14;

const CHASSIS: RGBColor = RGBColor(60, 60, 60);
const LINK: RGBColor = RGBColor(31, 90, 160);
const BODY: RGBColor = RGBColor(200, 80, 20);
const LENGTH: RGBColor = RGBColor(40, 130, 70);
const TYRE: RGBColor = RGBColor(120, 120, 120);
const AXIS: RGBColor = RGBColor(160, 40, 110);

/// The opacity of a mechanism that is drawn faintly.
const FAINT: f64 = 0.25;

impl Drawing {
    /// Returns the drawing as an SVG document of the given width and height in pixels; `None` if there are no points.
    pub fn svg(&self, seen: Seen, shown: (u32, u32)) -> Option<String> {
        let view = View::fit(&self.outline(), self.axes, seen, shown, MARGIN)?;
        document(shown, |area| self.draw(area, &view, shown))
    }

    fn draw(&self, area: &Area<'_>, view: &View, shown: (u32, u32)) -> Drawn {
        axes::draw(area, view, shown, self.unit)?;
        for other in &self.others {
            self.draw_mechanism(area, view, other, FAINT)?;
        }
        self.draw_mechanism(area, view, &self.points, 1.0)?;
        self.draw_forces(area, view)?;
        self.draw_points(area, view, shown)
    }

    /// Draws wheel, bodies and lines at a place of the motion, with the opacity `part`.
    fn draw_mechanism(
        &self,
        area: &Area<'_>,
        view: &View,
        at: &[Vector3<f64>],
        part: f64,
    ) -> Drawn {
        let pixel = |index: &usize| at.get(*index).map(|at| view.pixels(at));
        for rim in self.wheels.iter().filter_map(|wheel| rim(wheel, at)) {
            let rim: Vec<_> = rim.map(|at| view.pixels(&at)).collect();
            area.draw(&Polygon::new(rim.clone(), TYRE.mix(0.12 * part).filled()))?;
            area.draw(&PathElement::new(
                rim,
                TYRE.mix(part).stroke_width(2 * FINE),
            ))?;
        }
        for body in &self.bodies {
            let corners: Vec<_> = body.iter().filter_map(pixel).collect();
            let hull = hull::hull(corners);
            area.draw(&Polygon::new(hull.clone(), BODY.mix(0.22 * part).filled()))?;
            let closed = hull.iter().chain(hull.first()).copied();
            area.draw(&PathElement::new(
                closed.collect::<Vec<_>>(),
                BODY.mix(part).stroke_width(FINE),
            ))?;
        }
        for axis in self.axes(at) {
            let (dash, gap) = (14 * FINE, 4 * FINE);
            let stroke = AXIS.mix(part).stroke_width(FINE);
            let ends = axis.map(|at| view.pixels(&at));
            area.draw(&DashedPathElement::new(ends, dash, gap, stroke))?;
        }
        for line in &self.lengths {
            let (dash, gap) = (9 * FINE, 5 * FINE);
            let stroke = LENGTH.mix(part).stroke_width(2 * FINE);
            area.draw(&DashedPathElement::new(
                line.iter().filter_map(pixel),
                dash,
                gap,
                stroke,
            ))?;
        }
        let slides = self.slides.iter().map(|slide| (slide.as_slice(), 2));
        let links = self.links.iter().map(|link| (link.as_slice(), 4));
        for (line, width) in slides.chain(links) {
            let line: Vec<_> = line.iter().filter_map(pixel).collect();
            let stroke = LINK.mix(part).stroke_width(width * FINE);
            area.draw(&PathElement::new(line, stroke))?;
        }
        Ok(())
    }

    /// Returns kingpin and spin axis, extended beyond their points by a part of the wheel's radius.
    fn axes(&self, at: &[Vector3<f64>]) -> Vec<[Vector3<f64>; 2]> {
        const BEYOND: f64 = 0.4;
        let line = |([from, to], radius): ([usize; 2], f64)| {
            let (from, to) = (at.get(from)?, at.get(to)?);
            let along = to - from;
            let part = BEYOND * radius / along.norm();
            Some([-part, 1.0 + part].map(|part| from + along * part))
        };
        let of_wheel = |wheel: &Wheel| {
            let axes = wheel.kingpin.into_iter().chain([wheel.axis]);
            let radius = wheel.radius;
            axes.map(move |axis| (axis, radius))
        };
        let axes = self.wheels.iter().flat_map(of_wheel);
        axes.filter_map(line).collect()
    }

    fn draw_points(&self, area: &Area<'_>, view: &View, shown: (u32, u32)) -> Drawn {
        let places = self.points.iter().map(|at| view.pixels(at));
        let places: Vec<(i32, i32)> = places.collect();
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
        let labelled = shared_labels::labels(&self.names, &places, 2 * FINE as i32);
        let places: Vec<(i32, i32)> = labelled.iter().map(|(_, place)| *place).collect();
        let mut labels = Labels::new(&places, self.segments(view), shown, FINE as i32);
        for (name, place) in &labelled {
            put(area, &mut labels, (name, *place), [CHASSIS; 2])?;
        }
        self.draw_numbers(area, view, &mut labels)
    }

    /// Returns the lines that labels must avoid.
    fn segments(&self, view: &View) -> Vec<Segment> {
        let pixel = |index: &usize| self.points.get(*index).map(|at| view.pixels(at));
        let slides = self.slides.iter().map(|[from, to, _]| [*from, *to]);
        let lines = self
            .links
            .iter()
            .chain(&self.lengths)
            .copied()
            .chain(slides);
        let lines = lines.filter_map(|[from, to]| Some([pixel(&from)?, pixel(&to)?]));
        let edges = self.bodies.iter().flat_map(|body| {
            let hull = hull::hull(body.iter().filter_map(pixel).collect());
            let next = hull.iter().cycle().skip(1).copied();
            let edges = hull.iter().copied().zip(next).map(|(from, to)| [from, to]);
            edges.collect::<Vec<_>>()
        });
        let axes = self.axes(&self.points).into_iter();
        let axes = axes.map(|axis| axis.map(|at| view.pixels(&at)));
        lines.chain(edges).chain(axes).collect()
    }

    /// Returns all points that the drawing must contain.
    fn outline(&self) -> Vec<Vector3<f64>> {
        let each = [&self.points].into_iter().chain(&self.others);
        let with_rim = each.flat_map(|at| {
            let rims = self.wheels.iter().filter_map(|wheel| rim(wheel, at));
            at.iter().copied().chain(rims.flatten())
        });
        let arrows = self.arrows().into_iter().flatten();
        with_rim.chain(arrows).collect()
    }
}

fn pixels([x, y]: [f64; 2]) -> (i32, i32) {
    let fine = f64::from(FINE);
    ((x * fine).round() as i32, (y * fine).round() as i32)
}
