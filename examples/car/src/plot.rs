//! Plots as SVG: panels below each other.

use std::error::Error;
use std::ops::Range;
use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;

/// A panel: curves over a common axis.
#[derive(Clone, Debug)]
pub struct Panel {
    /// The horizontal axis, with its unit.
    pub across: String,
    /// The vertical axis, with its unit.
    pub quantity: String,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// A curve.
#[derive(Clone, Debug)]
pub struct Curve {
    /// In the legend.
    pub name: String,
    /// Across and up.
    pub line: Vec<(f64, f64)>,
}

const WIDTH: u32 = 900;
const HEIGHT: u32 = 260;
const FONT: &str = "sans-serif";

/// One colour a curve.
pub const COLOURS: [RGBColor; 4] = [
    RGBColor(31, 90, 160),
    RGBColor(200, 80, 20),
    RGBColor(40, 130, 60),
    RGBColor(130, 60, 140),
];

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Draws the panels into a file.
///
/// # Errors
///
/// Where the file cannot be written.
pub fn draw(title: &str, panels: &[Panel], to: &Path) -> Result<(), Box<dyn Error>> {
    let height = HEIGHT * panels.len() as u32 + 40;
    let area = SVGBackend::new(to, (WIDTH, height)).into_drawing_area();
    area.fill(&WHITE)?;
    let titled = area.titled(title, (FONT, 20))?;
    for (panel, area) in panels.iter().zip(titled.split_evenly((panels.len(), 1))) {
        panel.draw(&area)?;
    }
    area.present()?;
    Ok(())
}

impl Panel {
    fn draw(&self, area: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let points = || self.curves.iter().flat_map(|curve| &curve.line);
        let across = span(points().map(|point| point.0), 0.0);
        let up = span(points().map(|point| point.1), 0.08);
        let mut plane = ChartBuilder::on(area)
            .margin(8)
            .margin_right(20)
            .x_label_area_size(38)
            .y_label_area_size(60)
            .build_cartesian_2d(across, up)?;
        plane
            .configure_mesh()
            .x_desc(&self.across)
            .y_desc(&self.quantity)
            .axis_desc_style((FONT, 15))
            .label_style((FONT, 13))
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.12))
            .draw()?;
        for (curve, colour) in self.curves.iter().zip(COLOURS.iter().cycle()) {
            plane
                .draw_series(LineSeries::new(
                    curve.line.iter().copied(),
                    colour.stroke_width(1),
                ))?
                .label(&curve.name)
                .legend(move |(x, y)| {
                    PathElement::new([(x, y), (x + 20, y)], colour.stroke_width(2))
                });
        }
        plane
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperLeft)
            .label_font((FONT, 13))
            .background_style(WHITE.mix(0.8))
            .draw()?;
        Ok(())
    }
}

/// From the least to the largest, and a part of that beyond both.
fn span(values: impl Iterator<Item = f64>, margin: f64) -> Range<f64> {
    let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [low.min(value), high.max(value)]
    });
    let margin = margin * (high - low);
    low - margin..high + margin
}
