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
    /// The name in the legend.
    pub name: String,
    /// Across and up.
    pub line: Vec<(f64, f64)>,
}

const WIDTH: u32 = 900;
const HEIGHT: u32 = 230;
/// Room for the legend right of the curves, as a part of their span.
const LEGEND: f64 = 0.22;
/// Drawing units per pixel: plotters rounds to whole units, which would be visible as steps.
pub const FINE: u32 = 8;

/// One colour a curve.
pub const COLOURS: [RGBColor; 5] = [
    RGBColor(31, 90, 160),
    RGBColor(200, 80, 20),
    RGBColor(40, 130, 60),
    RGBColor(130, 60, 140),
    RGBColor(110, 110, 110),
];

/// The area of a drawing.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// A font of a size as shown.
pub fn font(size: u32) -> (&'static str, u32) {
    ("sans-serif", size * FINE)
}

/// Draws a picture of a width and a height in pixels into a file.
///
/// # Errors
///
/// Those of the drawing, and if the file cannot be written.
pub fn save(
    [width, height]: [u32; 2],
    title: &str,
    to: &Path,
    picture: impl FnOnce(&Area<'_>) -> Result<(), Box<dyn Error>>,
) -> Result<(), Box<dyn Error>> {
    let mut text = String::new();
    let area =
        SVGBackend::with_string(&mut text, (width * FINE, height * FINE)).into_drawing_area();
    area.fill(&WHITE)?;
    picture(&area.margin(8 * FINE, 0, 0, 0).titled(title, font(20))?)?;
    area.present()?;
    drop(area);
    let size = |fine| format!("width=\"{}\" height=\"{}\"", width * fine, height * fine);
    std::fs::write(to, text.replacen(&size(FINE), &size(1), 1))?;
    Ok(())
}

/// Draws the panels into a file.
///
/// # Errors
///
/// If the file cannot be written.
pub fn draw(title: &str, panels: &[Panel], to: &Path) -> Result<(), Box<dyn Error>> {
    let height = HEIGHT * panels.len() as u32 + 40;
    save([WIDTH, height], title, to, |area| {
        let areas = area.split_evenly((panels.len(), 1));
        panels
            .iter()
            .zip(&areas)
            .try_for_each(|(panel, area)| panel.draw(area))
    })
}

impl Panel {
    fn draw(&self, area: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let points = || self.curves.iter().flat_map(|curve| &curve.line);
        let across = span(points().map(|point| point.0), 0.0);
        let across = across.start..across.end + LEGEND * (across.end - across.start);
        let up = span(points().map(|point| point.1), 0.08);
        let mut plane = ChartBuilder::on(area)
            .margin(8 * FINE)
            .margin_right(20 * FINE)
            .x_label_area_size(38 * FINE)
            .y_label_area_size(60 * FINE)
            .build_cartesian_2d(across, up)?;
        plane
            .configure_mesh()
            .x_desc(&self.across)
            .y_desc(&self.quantity)
            .y_labels(7)
            .axis_desc_style(font(15))
            .label_style(font(13))
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.12).stroke_width(FINE))
            .axis_style(BLACK.stroke_width(FINE))
            .set_all_tick_mark_size(5 * FINE)
            .draw()?;
        for (curve, colour) in self.curves.iter().zip(COLOURS.iter().cycle()) {
            let line = LineSeries::new(curve.line.iter().copied(), colour.stroke_width(FINE));
            let stroke = colour.stroke_width(2 * FINE);
            plane
                .draw_series(line)?
                .label(&curve.name)
                .legend(move |(x, y)| {
                    PathElement::new([(x, y), (x + 20 * FINE as i32, y)], stroke)
                });
        }
        plane
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperRight)
            .legend_area_size(26 * FINE)
            .margin(4 * FINE)
            .label_font(font(13))
            .draw()?;
        Ok(())
    }
}

/// Returns the range of the values, extended on both sides by a part of it.
fn span(values: impl Iterator<Item = f64>, margin: f64) -> Range<f64> {
    let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [low.min(value), high.max(value)]
    });
    let margin = margin * (high - low);
    low - margin..high + margin
}
