//! The chart: operations, run time and build time over the number of bodies, both axes logarithmic.

use std::error::Error;

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::{Quantity, Row};

const SIZE: (u32, u32) = (1500, 520);
const COLOURS: [RGBColor; 4] = [
    RGBColor(31, 90, 160),
    RGBColor(200, 80, 20),
    RGBColor(40, 130, 60),
    RGBColor(120, 60, 140),
];

struct Panel {
    title: &'static str,
    curves: &'static [Quantity],
}

const PANELS: [Panel; 3] = [
    Panel {
        title: "operations, counts",
        curves: &[
            ("operations of a factorisation", |row| {
                row.factor_operations as f64
            }),
            ("operations of a solution", |row| {
                row.solve_operations as f64
            }),
            ("non-zeros of the factors", |row| {
                row.factor_non_zeros as f64
            }),
            ("longest chain of a factorisation", |row| {
                row.factor_chain as f64
            }),
        ],
    },
    Panel {
        title: "run time, microseconds",
        curves: &[("step of 1 ms", |row| row.step_us)],
    },
    Panel {
        title: "build time, seconds",
        curves: &[
            ("release build", |row| row.release_s),
            ("its processor time", |row| row.release_cpu_s),
            ("check", |row| row.check_s),
            ("expansion", |row| row.expansion_s),
        ],
    },
];

/// The chart as an SVG document.
pub(crate) fn svg(rows: &[Row]) -> Result<String, Box<dyn Error>> {
    let mut text = String::new();
    let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    for (panel, part) in PANELS.iter().zip(area.split_evenly((1, PANELS.len()))) {
        panel.draw(&part, rows).map_err(|error| error.to_string())?;
    }
    area.present()?;
    drop(area);
    Ok(text)
}

impl Panel {
    /// The least and the greatest value of all curves.
    fn ends(&self, rows: &[Row]) -> [f64; 2] {
        let of_row = |row| self.curves.iter().map(move |(_, value)| value(row));
        let values = || rows.iter().flat_map(of_row);
        [
            values().fold(f64::MAX, f64::min),
            values().fold(f64::MIN, f64::max),
        ]
    }

    fn draw<'a>(
        &self,
        area: &DrawingArea<SVGBackend<'a>, Shift>,
        rows: &[Row],
    ) -> Result<(), Box<dyn Error + 'a>> {
        let [low, high] = self.ends(rows);
        let most = rows.iter().map(|row| row.bodies).max().unwrap_or(1) as f64;
        let low = low.max(1e-6);
        // The legend is above the curves.
        let above = 10_f64.powf(0.35 * (high / low).log10().max(1.0));
        let mut plane = ChartBuilder::on(area)
            .caption(self.title, ("sans-serif", 20))
            .margin(12)
            .margin_right(24)
            .x_label_area_size(44)
            .y_label_area_size(70)
            .build_cartesian_2d(
                (0.9..1.1 * most).log_scale(),
                (0.8 * low..high * above).log_scale(),
            )?;
        plane
            .configure_mesh()
            .x_desc("bodies")
            .x_label_formatter(&|bodies| format!("{bodies:.0}"))
            .y_label_formatter(&|value| format!("{value}"))
            .bold_line_style(BLACK.mix(0.15))
            .light_line_style(TRANSPARENT)
            .x_labels(6)
            .label_style(("sans-serif", 14))
            .draw()?;
        for ((name, value), colour) in self.curves.iter().zip(COLOURS) {
            let point = |row: &Row| (row.bodies as f64, value(row).max(low));
            let points = || rows.iter().map(point);
            let line = colour.stroke_width(2);
            plane
                .draw_series(LineSeries::new(points(), line))?
                .label(*name)
                .legend(move |at| stroke(at, line));
            plane.draw_series(points().map(|point| Circle::new(point, 3, colour.filled())))?;
        }
        // A line parallel to linear growth.
        let linear = [(1.0, low), (most, low * most)];
        let line = BLACK.mix(0.4).into();
        plane
            .draw_series(LineSeries::new(linear, line))?
            .label("linear growth")
            .legend(move |at| stroke(at, line));
        plane
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperLeft)
            .background_style(WHITE.mix(0.85))
            .label_font(("sans-serif", 14))
            .draw()?;
        Ok(())
    }
}

/// A line in the legend.
fn stroke((x, y): (i32, i32), style: ShapeStyle) -> PathElement<(i32, i32)> {
    PathElement::new([(x, y), (x + 22, y)], style)
}
