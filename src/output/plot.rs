//! Plots as SVG: over time, or over another quantity.

mod axis;
#[cfg(test)]
mod tests;

use plotters::coord::types::RangedCoordf64;
use plotters::element::{DashedPathElement, DynElement, IntoDynElement};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::output::colour::Colour;
use crate::output::svg::{Area, Drawn, FINE, FONT, document};
use axis::{Axis, DIGIT, is_finite};

/// A plot.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The title.
    pub title: String,
    /// The label of the horizontal axis, with its unit.
    pub across: String,
    /// The label of the vertical axis, with its unit.
    pub quantity: String,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// A curve.
#[derive(Clone, Debug, Default)]
pub struct Curve {
    /// The name in the legend, which is omitted if no curve has a name.
    pub name: String,
    /// Points of the line, horizontal and vertical; a point that is not finite interrupts the line.
    pub line: Vec<(f64, f64)>,
    /// Points with a mark.
    pub marks: Vec<(f64, f64)>,
    /// Its colour.
    pub colour: Colour,
    /// Whether its line is dashed, which tells it from others in black and white too.
    pub is_dashed: bool,
}

/// Width and height in pixels.
const SIZE: (u32, u32) = (900, 560);
/// The margin of a plot, and that on its right, in pixels.
const MARGIN: [u32; 2] = [14, 28];
/// The heights of the title with a gap below it, and of what is below the horizontal axis, in pixels.
const TITLE: u32 = 46;
const BELOW: u32 = 48;

fn font(size: u32) -> (&'static str, u32) {
    (FONT, size * FINE)
}

/// Returns the font size, `size` at most, at which a text fits a width in pixels.
fn fitting(text: &str, size: u32, width: u32) -> u32 {
    // Letters are half as wide as high.
    let letters = text.chars().count() as u32;
    (2 * width / letters.max(1)).min(size)
}

type Plane<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

impl Chart {
    /// Returns the plot as an SVG document; `None` if it has no points.
    pub fn svg(&self) -> Option<String> {
        self.svg_of(SIZE)
    }

    /// Returns the plot with a width and a height in pixels.
    pub fn svg_of(&self, shown: (u32, u32)) -> Option<String> {
        let axes = self.axes(shown.1)?;
        document(shown, |area| self.draw(area, &axes, shown.0))
    }

    fn draw(&self, area: &Area<'_>, axes: &[Axis; 2], width: u32) -> Drawn {
        /// The width of the vertical axis without its numbers: its label, its ticks and gaps.
        const BESIDE_NUMBERS: u32 = 32;
        let [x, y] = axes;
        let beside = BESIDE_NUMBERS + y.label_width();
        let below = self.draw_title(area, width, width - 2 * MARGIN[0])?;
        let width = width - beside - MARGIN[0] - MARGIN[1];
        let mut plane = ChartBuilder::on(&below)
            .margin(MARGIN[0] * FINE)
            .margin_top(0)
            .margin_right(MARGIN[1] * FINE)
            .x_label_area_size(BELOW * FINE)
            .y_label_area_size(beside * FINE)
            .build_cartesian_2d(x.low..x.high, y.low..y.high)?;
        let name_size = fitting(&self.across, 17, width + MARGIN[1]);
        self.draw_axes(&mut plane, axes, width, name_size)?;
        // Marks that stand close together would hide a line.
        self.draw_marks(&mut plane)?;
        self.draw_curves(&mut plane, y)?;
        if self.curves.iter().all(|curve| curve.name.is_empty()) {
            return Ok(());
        }
        plane
            .configure_series_labels()
            .position(SeriesLabelPosition::Coordinate(
                12 * FINE as i32,
                12 * FINE as i32,
            ))
            .legend_area_size(34 * FINE)
            .label_font(font(15))
            .margin(8 * FINE)
            .background_style(WHITE.mix(0.85))
            .border_style(BLACK.mix(0.3).stroke_width(FINE))
            .draw()?;
        Ok(())
    }

    /// Draws the title of at most a width, in the middle; returns the area below it and a gap.
    fn draw_title<'b>(
        &self,
        area: &Area<'b>,
        width: u32,
        most: u32,
    ) -> Result<Area<'b>, Box<dyn std::error::Error>> {
        let (above, below) = area.split_vertically(TITLE * FINE);
        let style = TextStyle::from(font(fitting(&self.title, 22, most)).into_font());
        let style = style.pos(Pos::new(HPos::Center, VPos::Top));
        let at = [width / 2, MARGIN[0]].map(|pixels| (pixels * FINE) as i32);
        above.draw_text(&self.title, &style, at.into())?;
        Ok(below)
    }

    fn draw_axes(
        &self,
        plane: &mut Plane<'_, '_>,
        [x, y]: &[Axis; 2],
        width: u32,
        name_size: u32,
    ) -> Drawn {
        const MOST: u32 = 11;
        const ROWS: usize = 10;
        // The gap between numbers is at least two digits wide.
        let numbers = width / (x.label_width() + 2 * DIGIT);
        plane
            .configure_mesh()
            .x_desc(&self.across)
            .y_desc(&self.quantity)
            .x_labels(numbers.clamp(2, MOST) as usize)
            .y_labels(ROWS)
            .x_label_formatter(&|t| x.label(*t))
            .y_label_formatter(&|v| y.label(*v))
            .axis_desc_style(font(name_size))
            .label_style(font(15))
            .bold_line_style(BLACK.mix(0.15).stroke_width(FINE))
            .light_line_style(TRANSPARENT)
            .axis_style(BLACK.stroke_width(FINE))
            .set_all_tick_mark_size(5 * FINE)
            .draw()?;
        Ok(())
    }

    fn draw_marks(&self, plane: &mut Plane<'_, '_>) -> Drawn {
        for (index, curve) in self.curves.iter().enumerate() {
            let colour = curve.colour.of_curve(index);
            let marks = curve.marks.iter();
            plane.draw_series(marks.map(|mark| Circle::new(*mark, 4 * FINE, colour.filled())))?;
        }
        Ok(())
    }

    fn draw_curves<'a, 'b: 'a>(&self, plane: &mut Plane<'a, 'b>, up: &Axis) -> Drawn {
        for (index, curve) in self.curves.iter().enumerate() {
            let colour = curve.colour.of_curve(index);
            let mut later = self.curves[index + 1..].iter();
            // A curve that a later one covers, as that of the other wheel, shows on both sides of it.
            let is_covered = later.any(|other| up.shows_as_one(curve, other));
            let stroke = colour.stroke_width(if is_covered { 5 } else { 2 } * FINE);
            let is_dashed = curve.is_dashed;
            let runs = curve.line.split(|point| !is_finite(point));
            let drawn = runs.map(|run| path(run.to_vec(), stroke, is_dashed));
            let drawn = plane.draw_series(drawn)?.label(&curve.name);
            let in_legend = 24 * FINE as i32;
            if curve.line.is_empty() {
                drawn.legend(move |(x, y)| {
                    Circle::new((x + in_legend / 2, y), 4 * FINE, colour.filled())
                });
            } else {
                let ends = move |(x, y)| vec![(x, y), (x + in_legend, y)];
                drawn.legend(move |at| path(ends(at), stroke, is_dashed));
            }
        }
        Ok(())
    }

    /// Returns the horizontal and the vertical axis of a plot of a height in pixels: all points and a margin, with the legend above
    /// them.
    fn axes(&self, height: u32) -> Option<[Axis; 2]> {
        const MARGIN: f64 = 0.08;
        let curves = self.curves.iter();
        let all = curves.flat_map(|curve| curve.line.iter().chain(&curve.marks));
        let all: Vec<_> = all.copied().filter(is_finite).collect();
        let named = self.curves.iter().filter(|curve| !curve.name.is_empty());
        let legend = part_of_legend(named.count(), height);
        let above = (legend / (1.0 - legend) * (1.0 + MARGIN)).max(MARGIN);
        let time = Axis::fit(all.iter().map(|point| point.0), [0.02, 0.02])?;
        let value = Axis::fit(all.iter().map(|point| point.1), [MARGIN, above])?;
        Some([time, value])
    }
}

/// Returns the part of the vertical axis that a legend takes, and a gap below it.
fn part_of_legend(names: usize, height: u32) -> f64 {
    const NAME: usize = 19;
    /// The legend without its names, and the gap, in which marks at points have room.
    const AROUND: usize = 35;
    /// Points need the other part.
    const MOST: f64 = 0.7;
    let plane = height.saturating_sub(TITLE + BELOW + MARGIN[0]);
    match names {
        0 => 0.0,
        _ => ((AROUND + NAME * names) as f64 / f64::from(plane)).min(MOST),
    }
}

/// Returns a line through points, solid or dashed.
fn path<'b, P: Clone + 'static>(
    points: Vec<P>,
    stroke: ShapeStyle,
    is_dashed: bool,
) -> DynElement<'static, SVGBackend<'b>, P> {
    const DASH: u32 = 8 * FINE;
    const GAP: u32 = 4 * FINE;
    match is_dashed {
        true => DashedPathElement::new(points, DASH, GAP, stroke).into_dyn(),
        false => PathElement::new(points, stroke).into_dyn(),
    }
}
