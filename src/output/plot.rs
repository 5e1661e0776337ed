//! Plots over time as SVG.

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::study::sweep::Rows;

/// A plot over time.
#[derive(Clone, Debug)]
pub struct Chart {
    /// Above the plot.
    pub title: String,
    /// The vertical axis, with its unit.
    pub quantity: String,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// A curve over time.
#[derive(Clone, Debug)]
pub struct Curve {
    /// In the legend.
    pub name: String,
    /// Points of the line: time in s, value.
    pub line: Vec<(f64, f64)>,
    /// Points that are marked.
    pub marks: Vec<(f64, f64)>,
}

impl Curve {
    /// From columns of a dense and a sparse sweep, times `scale`.
    pub fn new(name: impl Into<String>, column: &str, scale: f64, rows: [&Rows; 2]) -> Self {
        let [line, marks] = rows.map(|rows| {
            let values = rows.column(column).unwrap_or_default();
            let times = rows.column("t_s").unwrap_or_default();
            let points = times.into_iter().zip(values.into_iter().map(|v| v * scale));
            points.filter(|(_, value)| value.is_finite()).collect()
        });
        Self {
            name: name.into(),
            line,
            marks,
        }
    }
}

/// Width and height as shown.
const SIZE: (u32, u32) = (900, 560);
/// Drawing units to one of those: plotters rounds to whole units, which would be seen as steps.
const FINE: u32 = 8;
const FONT: &str = "sans-serif";
fn font(size: u32) -> (&'static str, u32) {
    (FONT, size * FINE)
}

const COLOURS: [RGBColor; 3] = [
    RGBColor(31, 90, 160),
    RGBColor(200, 80, 20),
    RGBColor(40, 130, 60),
];

impl Chart {
    /// The plot as an SVG document; `None` where there is nothing to draw.
    pub fn svg(&self) -> Option<String> {
        let [x, y] = self.ranges()?;
        let mut text = String::new();
        let size = (SIZE.0 * FINE, SIZE.1 * FINE);
        let area = SVGBackend::with_string(&mut text, size).into_drawing_area();
        // Drawing into memory has no way to fail but a mistake in this file.
        self.draw(&area, x, y).ok()?;
        drop(area);
        let [drawn, shown] =
            [size, SIZE].map(|(width, height)| format!("width=\"{width}\" height=\"{height}\""));
        Some(text.replacen(&drawn, &shown, 1))
    }

    fn draw(
        &self,
        area: &DrawingArea<SVGBackend<'_>, Shift>,
        x: [f64; 2],
        y: [f64; 2],
    ) -> Result<(), Box<dyn std::error::Error>> {
        area.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(area)
            .caption(&self.title, font(22))
            .margin(14 * FINE)
            .margin_right(28 * FINE)
            .x_label_area_size(48 * FINE)
            .y_label_area_size(72 * FINE)
            .build_cartesian_2d(x[0]..x[1], y[0]..y[1])?;
        let [x_digits, y_digits] = [x, y].map(digits);
        chart
            .configure_mesh()
            .x_desc("time t (s)")
            .y_desc(&self.quantity)
            .x_labels(11)
            .y_labels(10)
            .x_label_formatter(&|t| format!("{t:.x_digits$}"))
            .y_label_formatter(&|v| format!("{v:.y_digits$}"))
            .axis_desc_style(font(17))
            .label_style(font(15))
            .bold_line_style(BLACK.mix(0.15).stroke_width(FINE))
            .light_line_style(TRANSPARENT)
            .axis_style(BLACK.stroke_width(FINE))
            .set_all_tick_mark_size(5 * FINE)
            .draw()?;
        for (curve, colour) in self.curves.iter().zip(COLOURS.iter().cycle()) {
            let line = LineSeries::new(curve.line.iter().copied(), colour.stroke_width(2 * FINE));
            chart
                .draw_series(line)?
                .label(&curve.name)
                .legend(move |(x, y)| {
                    PathElement::new(
                        [(x, y), (x + 24 * FINE as i32, y)],
                        colour.stroke_width(2 * FINE),
                    )
                });
            let marks = curve.marks.iter();
            chart.draw_series(marks.map(|mark| Circle::new(*mark, 4 * FINE, colour.filled())))?;
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperMiddle)
            .legend_area_size(34 * FINE)
            .label_font(font(15))
            .margin(8 * FINE)
            .background_style(WHITE.mix(0.85))
            .border_style(BLACK.mix(0.3).stroke_width(FINE))
            .draw()?;
        area.present()?;
        Ok(())
    }

    /// What the axes span: all points and a margin.
    fn ranges(&self) -> Option<[[f64; 2]; 2]> {
        let all = || {
            self.curves
                .iter()
                .flat_map(|c| c.line.iter().chain(&c.marks))
        };
        let x = range(all().map(|point| point.0), [0.02, 0.02])?;
        // The legend is above the curves.
        let y = range(all().map(|point| point.1), [0.08, 0.2])?;
        Some([x, y])
    }
}

fn range(values: impl Iterator<Item = f64>, [below, above]: [f64; 2]) -> Option<[f64; 2]> {
    let (low, high) = values.fold(None, |ends: Option<(f64, f64)>, value| {
        let (low, high) = ends.unwrap_or((value, value));
        Some((low.min(value), high.max(value)))
    })?;
    // A constant gets a range of its own size, so that rounding is not drawn as a wave.
    let span = (high - low).max(high.abs().max(low.abs()) * 1e-6).max(1e-9);
    Some([low - below * span, high + above * span])
}

/// Decimals that tell labels apart on an axis of about ten.
fn digits([low, high]: [f64; 2]) -> usize {
    let step = (high - low) / 10.0;
    (-step.log10()).ceil().clamp(0.0, 12.0) as usize
}
