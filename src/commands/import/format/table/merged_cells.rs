//! Cells that a spreadsheet has merged: the name of a part, a point or a side stands in the first of several rows alone.

use crate::commands::import::format::fields::{BETWEEN_COLUMNS, is_number};
use crate::commands::import::format::lines::Line;

/// Writes the words of the row above into the empty cells at the start of each row of numbers.
pub(super) fn with_merged_cells(mut lines: Vec<Line<'_>>) -> Vec<Line<'_>> {
    for below in 1..lines.len() {
        if let Some(whole) = filled(&lines[below].1, &lines[below - 1].1) {
            lines[below].1 = whole.into();
        }
    }
    lines
}

/// Returns a row with the words of the row above in its first cells; `None` if they are not empty, or either row has no numbers
/// behind a word.
fn filled(line: &str, above: &str) -> Option<String> {
    let separator = BETWEEN_COLUMNS.into_iter().find(|c| line.contains(*c))?;
    let (cells, above) = (cells(line, separator), cells(above, separator));
    let word = first_word(&cells)?;
    first_word(&above)?;
    let mut is_filled = false;
    let mut whole = cells.clone();
    for (cell, above) in whole.iter_mut().zip(&above).take(word) {
        if is_blank(cell) && is_word(above) {
            *cell = above;
            is_filled = true;
        }
    }
    is_filled.then(|| whole.join(&separator.to_string()))
}

fn cells(line: &str, separator: char) -> Vec<&str> {
    line.split(separator).collect()
}

/// Returns the place of the first cell with a word, if numbers follow it.
fn first_word(cells: &[&str]) -> Option<usize> {
    let word = cells.iter().position(|cell| is_word(cell))?;
    cells[word..]
        .iter()
        .any(|cell| is_number(cell))
        .then_some(word)
}

fn is_word(cell: &str) -> bool {
    !is_blank(cell) && !is_number(cell)
}

fn is_blank(cell: &str) -> bool {
    cell.trim_matches(['\'', '"', ' ', '\t']).is_empty()
}
