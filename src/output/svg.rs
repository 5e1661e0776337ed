//! Documents in SVG.

use plotters::coord::Shift;
use plotters::prelude::*;

/// Drawing units per pixel: plotters rounds to whole units, which would be visible as steps.
pub(super) const FINE: u32 = 8;

/// The font of all texts.
pub(super) const FONT: &str = "sans-serif";

pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
pub(super) type Drawn = Result<(), Box<dyn std::error::Error>>;

/// Returns what `draw` draws on a white sheet, whose width and height are in pixels.
pub(super) fn document(shown: (u32, u32), draw: impl FnOnce(&Area<'_>) -> Drawn) -> Option<String> {
    let mut text = String::new();
    let size = (shown.0 * FINE, shown.1 * FINE);
    let area = SVGBackend::with_string(&mut text, size).into_drawing_area();
    // Drawing into memory fails only by a mistake of the program.
    area.fill(&WHITE).ok()?;
    draw(&area).ok()?;
    area.present().ok()?;
    drop(area);
    let [drawn, shown] =
        [size, shown].map(|(width, height)| format!("width=\"{width}\" height=\"{height}\""));
    Some(text.replacen(&drawn, &shown, 1))
}
