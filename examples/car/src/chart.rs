//! The chart of details: the time of a tick against four errors.

use std::error::Error;
use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::plot::COLOURS;

/// A detail in the chart.
#[derive(Clone, Copy, Debug)]
pub struct Mark {
    /// In the legend.
    pub name: &'static str,
    /// Of a tick, us.
    pub time: f64,
    /// As [`QUANTITIES`]; zero is drawn at the left edge.
    pub errors: [f64; 4],
}

/// What the errors are.
pub const QUANTITIES: [&str; 4] = [
    "wheel centre at the same travel, largest error in m",
    "camber at the same travel, largest error in deg",
    "wheel loads, rms error in N",
    "place of the car after ten seconds, error in m",
];

const SIZE: (u32, u32) = (1000, 720);
const FONT: &str = "sans-serif";
/// Decades from the left edge to the right.
const DECADES: f64 = 9.0;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Draws four panels; a dashed line is the error that the step of the integrator makes itself.
///
/// # Errors
///
/// Where the file cannot be written.
pub fn draw(marks: &[Mark], step: &[f64; 4], to: &Path) -> Result<(), Box<dyn Error>> {
    let area = SVGBackend::new(to, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let titled = area.titled(
        "A tick of the car: time against error of its kinematics",
        (FONT, 20),
    )?;
    for (quantity, area) in titled.split_evenly((2, 2)).iter().enumerate() {
        panel(quantity, marks, step[quantity], area)?;
    }
    area.present()?;
    Ok(())
}

fn panel(
    quantity: usize,
    marks: &[Mark],
    step: f64,
    area: &Area<'_>,
) -> Result<(), Box<dyn Error>> {
    let largest = marks
        .iter()
        .map(|mark| mark.errors[quantity])
        .fold(step, f64::max);
    let right = 10.0_f64.powf(largest.log10().ceil() + 0.3);
    let left = right / 10.0_f64.powf(DECADES);
    let slowest = marks.iter().map(|mark| mark.time).fold(0.0, f64::max);
    let mut plane = ChartBuilder::on(area)
        .margin(10)
        .margin_right(24)
        .x_label_area_size(42)
        .y_label_area_size(56)
        .build_cartesian_2d((left..right).log_scale(), 0.0..1.25 * slowest)?;
    plane
        .configure_mesh()
        .x_desc(QUANTITIES[quantity])
        .y_desc("time of a tick in us")
        .x_label_formatter(&|error| format!("{error:.0e}"))
        .axis_desc_style((FONT, 15))
        .label_style((FONT, 13))
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.12))
        .draw()?;
    if step > 0.0 {
        let line = [(step, 0.0), (step, 1.25 * slowest)];
        plane
            .draw_series(DashedLineSeries::new(line, 5, 4, BLACK.mix(0.6).into()))?
            .label("the step of 1 ms itself")
            .legend(|(x, y)| PathElement::new([(x, y), (x + 14, y)], BLACK.mix(0.6)));
    }
    for (mark, colour) in marks.iter().zip(COLOURS.iter()) {
        let error = mark.errors[quantity];
        let name = if error > 0.0 {
            mark.name.to_owned()
        } else {
            format!("{}: 0", mark.name)
        };
        let at = (error.max(left), mark.time);
        plane
            .draw_series([Circle::new(at, 6, colour.filled())])?
            .label(name)
            .legend(move |(x, y)| Circle::new((x + 7, y), 5, colour.filled()));
    }
    plane
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .label_font((FONT, 13))
        .background_style(WHITE.mix(0.85))
        .border_style(BLACK.mix(0.3))
        .draw()?;
    Ok(())
}
