//! Errors of a spreadsheet's formulas in the cells of a table, such as `#REF!`.

use crate::commands::import::format::fields::BETWEEN_COLUMNS;

/// The errors that do not end with a sign of their own: those of values that are not available.
const NOT_AVAILABLE: [&str; 4] = ["#N/A", "#NV", "#ND", "#N/D"];

/// Returns the first cell with an error, and the line before it.
pub(super) fn first_error(line: &str) -> Option<(&str, &str)> {
    let mut start = 0;
    line.split(BETWEEN_COLUMNS).find_map(|cell| {
        let before = &line[..start];
        start += cell.len() + 1;
        let cell = cell.trim_matches(['\'', '"', ' ']);
        is_error(cell).then_some((before, cell))
    })
}

/// Returns whether a cell is an error, or the signs that Excel writes for a column that is too narrow.
fn is_error(cell: &str) -> bool {
    let is_narrow = cell.len() > 1 && cell.bytes().all(|c| c == b'#');
    let is_word = !cell.contains(char::is_whitespace) && cell.ends_with(['!', '?']);
    let is_code = cell
        .strip_prefix("Err:")
        .is_some_and(|code| code.bytes().all(|c| c.is_ascii_digit()));
    is_narrow || is_code || cell.starts_with('#') && (is_word || NOT_AVAILABLE.contains(&cell))
}
