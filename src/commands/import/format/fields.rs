//! The fields of a line of a table.

use crate::commands::import::length_units::is_unit;
use crate::decimals::Decimals;

/// The signs between columns.
pub(super) const BETWEEN_COLUMNS: [char; 4] = [';', '\t', '|', ','];

/// Returns the number in a field; `inf` and `nan` are none.
pub(super) fn number(field: &str, with_comma: bool, decimals: Decimals) -> Option<f64> {
    let field = field.trim();
    if field.contains(',') && !with_comma {
        return None;
    }
    decimals.number(field)
}

/// Returns whether a cell between commas or other separators has a number, with a unit or without.
pub(super) fn is_number(cell: &str) -> bool {
    let cell = cell.trim_matches(|c: char| c.is_whitespace() || "'\"".contains(c));
    number(without_unit(cell).0, true, Decimals::default()).is_some()
}

/// Returns whether `(90)` stands somewhere, a single number in parentheses. Lotus numbers its points so: `POINT (3)`.
pub(super) fn has_number_in_parentheses(line: &str) -> bool {
    let mut opened = line.match_indices('(');
    opened.any(|(at, _)| {
        let (before, behind) = (line[..at].trim_end(), &line[at + 1..]);
        let inside = behind.split_once(')').map(|(inside, _)| inside);
        inside.is_some_and(is_number) && !before.to_lowercase().ends_with("point")
    })
}

/// Returns whether a cell between the coordinates of a point is empty, so that a number behind them may take the place of one.
pub(super) fn has_empty_coordinate(line: &str, separator: char) -> bool {
    let (mut numbers, mut is_open) = (0, false);
    line.split(separator).any(|cell| {
        if cell.trim_matches(['\'', '"', ' ', '\t']).is_empty() {
            is_open |= numbers % 3 != 0;
        } else if is_number(cell) {
            numbers += 1;
            return is_open;
        } else {
            (numbers, is_open) = (0, false);
        }
        false
    })
}

/// Removes the names of the axes from `x = 1, y = 2, z = 3`.
pub(super) fn without_axes(fields: Vec<&str>) -> Vec<&str> {
    let is_axes = |labels: &[&str]| {
        let mut pairs = labels.iter().step_by(2).zip(["x", "y", "z"]);
        pairs.all(|(label, axis)| label.eq_ignore_ascii_case(axis))
    };
    match fields.windows(6).position(is_axes) {
        Some(x) => {
            let labels = [x, x + 2, x + 4];
            let others = fields.into_iter().enumerate();
            others
                .filter(|(place, _)| !labels.contains(place))
                .map(|(_, field)| field)
                .collect()
        }
        None => fields,
    }
}

/// Words of degrees behind a number, as in `-1.6 deg`.
const DEGREES: [&str; 5] = ["°", "deg", "degree", "degrees", "grad"];

/// Splits a field such as `130 mm` into a number, or other text, and the word behind it.
fn without_unit(field: &str) -> (&str, &str) {
    let of_word = |c: char| c.is_alphabetic() || c == '°';
    let number = field.trim_end_matches(of_word).trim_end();
    (number, field[number.len()..].trim_start())
}

/// Removes units, as in `130 mm`, and returns those of length. Between blanks, `in` and `m` before the numbers are words.
pub(super) fn without_units(fields: Vec<&str>, separator: char) -> (Vec<&str>, Vec<&str>) {
    let (mut others, mut units, mut has_number) = (Vec::new(), Vec::new(), false);
    for field in fields {
        let (number, behind) = without_unit(field);
        let is_number = number.ends_with(|c: char| c.is_ascii_digit() || c == '.')
            && !number.contains(char::is_alphabetic);
        let may_be_a_word = ["in", "m"].contains(&behind) && separator == ' ' && !has_number;
        has_number |= is_number;
        let is_alone = number.is_empty() && !may_be_a_word;
        if is_unit(behind) && (is_number || is_alone) {
            units.push(behind);
            others.extend(is_number.then_some(number));
        } else if is_number && DEGREES.contains(&behind.to_lowercase().as_str()) {
            others.push(number);
        } else {
            others.push(field);
        }
    }
    (others, units)
}

/// Returns the fields of a line without quotes and empty fields. The apostrophe of `Watt's link` is no quote.
pub(super) fn fields(line: &str, separator: char) -> Vec<&str> {
    let (mut quote, mut before) = (None, ' ');
    let apart = move |c: char| {
        let is_within_word = std::mem::replace(&mut before, c).is_alphanumeric();
        if quote.is_none() && (c == '"' || c == '\'' && !is_within_word) {
            quote = Some(c);
        } else if quote == Some(c) {
            quote = None;
        }
        let is_blank = separator == ' ' && c.is_whitespace();
        quote.is_none() && (c == separator || is_blank || "=:[](){}".contains(c))
    };
    let fields = line.split(apart);
    // Between blanks a comma may follow a number, as in `name 1, 2, 3`.
    let around = if separator == ' ' {
        "'\"\\$,"
    } else {
        "'\"\\$"
    };
    let fields =
        fields.map(|field| field.trim_matches(|c: char| c.is_whitespace() || around.contains(c)));
    fields.filter(|field| !field.is_empty()).collect()
}
