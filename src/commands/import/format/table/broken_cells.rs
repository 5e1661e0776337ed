//! Cells in quotes that have several lines, as spreadsheets write a heading with its unit below.

use crate::commands::import::format::fields::BETWEEN_COLUMNS;
use crate::commands::import::format::lines::Line;

/// Joins the lines of each cell, with a blank between them.
pub(super) fn with_whole_cells(lines: Vec<Line<'_>>) -> Vec<Line<'_>> {
    let mut whole: Vec<Line<'_>> = Vec::new();
    for (place, line) in lines {
        match whole.last_mut() {
            Some((before, above)) if goes_on(above) && line.contains('"') => {
                before.end = place.end;
                above.to_mut().push(' ');
                above.to_mut().push_str(&line);
            }
            _ => whole.push((place, line)),
        }
    }
    whole
}

/// Returns whether the last cell of a line begins with a quote and does not end. A quote alone stands for the cell above.
fn goes_on(line: &str) -> bool {
    let last = line.rsplit(BETWEEN_COLUMNS).next().unwrap_or(line).trim();
    last.len() > 1 && last.rfind('"') == Some(0)
}
