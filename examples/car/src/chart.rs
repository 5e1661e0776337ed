//! The chart of details: the time of a tick against four errors.

use std::error::Error;
use std::path::Path;

use plotters::prelude::*;

use crate::plot::{Area, COLOURS, FINE, font, save};

/// A detail in the chart.
#[derive(Clone, Copy, Debug)]
pub struct Mark {
    /// The name in the legend.
    pub name: &'static str,
    /// The time of a tick, µs.
    pub time: f64,
    /// The errors in the order of [`QUANTITIES`]; zero is drawn at the left edge.
    pub errors: [f64; 4],
}

impl Mark {
    /// The name, marked if the error is zero, because that is not where the point is drawn.
    fn label(&self, quantity: usize) -> String {
        if self.errors[quantity] > 0.0 {
            self.name.to_owned()
        } else {
            format!("{}: 0", self.name)
        }
    }
}

/// The titles of the errors.
pub const QUANTITIES: [&str; 4] = [
    "wheel centre at the same travel, largest error in m",
    "camber at the same travel, largest error in deg",
    "wheel loads, rms error in N",
    "place of the car after ten seconds, error in m",
];

const SIZE: [u32; 2] = [1000, 720];
/// Decades from the left edge to the right.
const DECADES: f64 = 9.0;

/// Draws four panels; a dashed line is the error of the integrator's own step.
///
/// # Errors
///
/// If the file cannot be written.
pub fn draw(marks: &[Mark], step: &[f64; 4], to: &Path) -> Result<(), Box<dyn Error>> {
    let title = "A tick of the car: time against error of its kinematics";
    save(SIZE, title, to, |area| {
        let areas = area.split_evenly((2, 2));
        (0..QUANTITIES.len())
            .try_for_each(|quantity| panel(quantity, marks, step[quantity], &areas[quantity]))
    })
}

/// Returns the left and the right edge of a panel, the largest error near the right one.
fn edges(errors: impl Iterator<Item = f64>, step: f64) -> [f64; 2] {
    let largest = errors.fold(step, f64::max);
    let right = 10.0_f64.powf(largest.log10().ceil() + 0.3);
    [right / 10.0_f64.powf(DECADES), right]
}

fn panel(
    quantity: usize,
    marks: &[Mark],
    step: f64,
    area: &Area<'_>,
) -> Result<(), Box<dyn Error>> {
    let [left, right] = edges(marks.iter().map(|mark| mark.errors[quantity]), step);
    let slowest = marks.iter().map(|mark| mark.time).fold(0.0, f64::max);
    let mut plane = ChartBuilder::on(area)
        .margin(10 * FINE)
        .margin_right(24 * FINE)
        .x_label_area_size(42 * FINE)
        .y_label_area_size(56 * FINE)
        .build_cartesian_2d((left..right).log_scale(), 0.0..1.25 * slowest)?;
    plane
        .configure_mesh()
        .x_desc(QUANTITIES[quantity])
        .y_desc("time of a tick in µs")
        .x_label_formatter(&|error| format!("{error:.0e}"))
        .axis_desc_style(font(15))
        .label_style(font(13))
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.12).stroke_width(FINE))
        .axis_style(BLACK.stroke_width(FINE))
        .set_all_tick_mark_size(5 * FINE)
        .draw()?;
    if step > 0.0 {
        let line = [(step, 0.0), (step, 1.25 * slowest)];
        let dark = BLACK.mix(0.6).stroke_width(FINE);
        plane
            .draw_series(DashedLineSeries::new(line, 5 * FINE, 4 * FINE, dark))?
            .label("the step of 1 ms itself")
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 14 * FINE as i32, y)], dark));
    }
    for (mark, colour) in marks.iter().zip(COLOURS.iter()) {
        let at = (mark.errors[quantity].max(left), mark.time);
        plane
            .draw_series([Circle::new(at, 6 * FINE, colour.filled())])?
            .label(mark.label(quantity))
            .legend(move |(x, y)| Circle::new((x + 7 * FINE as i32, y), 5 * FINE, colour.filled()));
    }
    plane
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .label_font(font(13))
        .background_style(WHITE.mix(0.85))
        .border_style(BLACK.mix(0.3).stroke_width(FINE))
        .legend_area_size(20 * FINE)
        .margin(8 * FINE)
        .draw()?;
    Ok(())
}
