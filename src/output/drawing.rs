//! A drawing of a linkage as SVG: chassis points, links, racks, slides, bodies, driven and measured lengths,
//! bars, the wheels and their axes.

mod axes;
mod first_instant;
mod forces;
mod hull;
mod labels;
mod legend;
mod marks;
mod rack;
mod shared_labels;
#[cfg(test)]
mod tests;
mod view;
mod wheel_rim;

use nalgebra::Vector3;

use crate::failure::Failure;
use crate::mechanism::Axes;
use crate::output::svg::{Area, Drawn, FINE, document};
pub use first_instant::{drawing_of, usual_radius};
pub use forces::{Acting, Forces, InLink};
use labels::{Labels, Segment};
use marks::{CHASSIS, Place};
pub use rack::Rack;
pub use view::Seen;
use view::View;
use wheel_rim::rim;

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
    /// Steering racks.
    pub racks: Vec<Rack>,
    /// Slides: the ends of each line and the point on it, by their indices.
    pub slides: Vec<[usize; 3]>,
    /// Measured lengths, springs and dampers among them: the ends of each, by their indices.
    pub lengths: Vec<[usize; 2]>,
    /// The lines of measured angles, anti-roll bars among them: the ends of each, by their indices.
    pub bars: Vec<[usize; 2]>,
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
const SIZE: (u32, u32) = (900, 640);
const MARGIN: f64 = 70.0;
const FONT_SIZE: u32 = 14;

/// The opacity of a mechanism that is drawn faintly.
const FAINT: f64 = 0.25;

impl Drawing {
    /// Returns the drawing of the mechanism of a file in the oblique view, as an SVG document.
    ///
    /// # Errors
    ///
    /// [`Failure::Solver`] if there are no points.
    pub fn whole(&self, file: &str) -> Result<String, Failure> {
        let nothing = || Failure::Solver(format!("{file}: nothing to draw"));
        self.svg(Seen::Oblique, SIZE).ok_or_else(nothing)
    }

    /// Returns the drawing as an SVG document of the given width and height in pixels; `None` if there are no points.
    pub fn svg(&self, seen: Seen, shown: (u32, u32)) -> Option<String> {
        let view = View::fit(&self.outline(), self.axes, seen, shown, MARGIN)?;
        document(shown, |area| self.draw(area, &view, shown))
    }

    fn draw(&self, area: &Area<'_>, view: &View, shown: (u32, u32)) -> Drawn {
        let texts = axes::draw(area, view, shown, self.unit)?;
        for other in &self.others {
            self.draw_mechanism(area, view, other, FAINT)?;
        }
        self.draw_mechanism(area, view, &self.points, 1.0)?;
        self.draw_forces(area, view)?;
        self.draw_points(area, view, (shown, &texts))
    }

    /// Draws wheels, bodies and lines at a place of the motion.
    fn draw_mechanism(
        &self,
        area: &Area<'_>,
        view: &View,
        at: &[Vector3<f64>],
        opacity: f64,
    ) -> Drawn {
        let pixel = |index: &usize| at.get(*index).map(|at| view.pixels(at));
        for rim in self.wheels.iter().filter_map(|wheel| rim(wheel, at)) {
            let rim = rim.map(|at| view.pixels(&at)).collect();
            marks::tyre(area, rim, opacity)?;
        }
        let line = |indices: &[usize]| indices.iter().filter_map(pixel).collect();
        for body in &self.bodies {
            marks::body(area, line(body), opacity)?;
        }
        for axis in self.axes(at) {
            marks::axis(area, axis.map(|at| view.pixels(&at)).into(), opacity)?;
        }
        for length in self.without_force(&self.lengths) {
            marks::length(area, line(length), opacity)?;
        }
        for slide in &self.slides {
            marks::slide(area, line(slide), opacity)?;
        }
        for link in self.without_force(&self.links) {
            marks::link(area, line(link), opacity)?;
        }
        for rack in self.racks.iter().filter_map(|rack| rack.line(at)) {
            marks::rack(area, rack.map(|at| view.pixels(&at)).into(), opacity)?;
        }
        for bar in &self.bars {
            marks::bar(area, line(bar), opacity)?;
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

    /// Draws the points with their names, which avoid the `texts` that are there.
    fn draw_points(
        &self,
        area: &Area<'_>,
        view: &View,
        (shown, texts): ((u32, u32), &[[i32; 4]]),
    ) -> Drawn {
        let places = self.points.iter().map(|at| view.pixels(at));
        let places: Vec<(i32, i32)> = places.collect();
        for (index, &place) in places.iter().enumerate() {
            if index < self.chassis {
                marks::chassis_point(area, place)?;
            } else {
                marks::moving_point(area, place)?;
            }
        }
        let labelled = shared_labels::labels(&self.names, &places, 2 * FINE as i32);
        let places: Vec<(i32, i32)> = labelled.iter().map(|(_, place)| *place).collect();
        let mut labels = Labels::new(&places, self.segments(view), shown, FINE as i32);
        texts.iter().for_each(|text| labels.avoid(*text));
        if view.seen == Seen::Oblique {
            labels.avoid(self.draw_legend(area, shown)?);
        }
        let boxes = labels.put_all(&labelled);
        for ((name, _), boxed) in labelled.iter().zip(&boxes) {
            labels.draw(area, name, boxed, [CHASSIS; 2])?;
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
            .chain(&self.bars)
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
        let racks = self.racks.iter().filter_map(|rack| rack.line(&self.points));
        let others = axes.chain(self.arrows()).chain(racks);
        let others = others.map(|line| line.map(|at| view.pixels(&at)));
        lines.chain(edges).chain(others).collect()
    }

    /// Returns all points that the drawing must contain.
    fn outline(&self) -> Vec<Vector3<f64>> {
        let each = [&self.points].into_iter().chain(&self.others);
        let with_rim = each.flat_map(|at| {
            let rims = self.wheels.iter().filter_map(|wheel| rim(wheel, at));
            at.iter().copied().chain(rims.flatten())
        });
        let racks = self.racks.iter().filter_map(|rack| rack.line(&self.points));
        let lines = self.arrows().into_iter().chain(racks).flatten();
        with_rim.chain(lines).collect()
    }
}

fn pixels([x, y]: [f64; 2]) -> (i32, i32) {
    let fine = f64::from(FINE);
    ((x * fine).round() as i32, (y * fine).round() as i32)
}

/// Returns the place halfway between two places on the sheet.
fn middle([from, to]: [Place; 2]) -> Place {
    (i32::midpoint(from.0, to.0), i32::midpoint(from.1, to.1))
}
