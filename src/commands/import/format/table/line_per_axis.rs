//! Points whose coordinates have a line each, as in `lca_front_x = 130` or, in YAML and JSON, below the name of the point.

use crate::commands::import::format::fields::is_number;
use crate::commands::import::format::lines::{Line, without_remark};
use crate::commands::import::length_units::is_unit;

/// Joins three lines with x, y and z of one point to one line with its name and three numbers.
pub(super) fn joined<'a>(lines: impl Iterator<Item = Line<'a>>) -> Vec<Line<'a>> {
    let mut joined: Vec<Line<'a>> = Vec::new();
    for line in lines {
        joined.push(line);
        let Some((before, [(from, x), (_, y), (to, z)])) = joined.split_last_chunk() else {
            continue;
        };
        let above = before.last().map_or("", |(_, above)| above);
        if let Some(point) = point([x, y, z], above) {
            let place = from.start..to.end;
            joined.truncate(before.len());
            joined.push((place, point.into()));
        }
    }
    joined
}

/// Returns the line of a point, if its lines have one name and the axes in their order. The line above may have the name.
fn point(lines: [&str; 3], above: &str) -> Option<String> {
    let [x, y, z] = lines.map(Coordinate::read);
    let (x, y, z) = (x?, y?, z?);
    let is_point = [(&x, "x"), (&y, "y"), (&z, "z")]
        .into_iter()
        .all(|(at, axis)| at.name == x.name && at.axis.eq_ignore_ascii_case(axis));
    let name = match x.name {
        "" => name_in(above),
        name => name,
    };
    let [x, y, z] = [x, y, z].map(|at| format!("{} {}", at.value, at.unit));
    (is_point && !name.is_empty()).then(|| format!("{name}; {x}; {y}; {z}"))
}

/// Returns the name in `lca_front:`, `"lca_front": {` or `- name: lca_front`.
fn name_in(line: &str) -> &str {
    let parts = line.rsplit([':', '=']).map(trimmed);
    parts
        .into_iter()
        .find(|part| !part.is_empty())
        .unwrap_or("")
}

/// A line with one coordinate of a point.
struct Coordinate<'a> {
    name: &'a str,
    axis: &'a str,
    value: &'a str,
    /// The unit in brackets behind the axis or in a column behind the number, or nothing.
    unit: &'a str,
}

impl<'a> Coordinate<'a> {
    fn read(line: &'a str) -> Option<Self> {
        let line = without_remark(line)
            .trim_start()
            .trim_end_matches([';', ',', ' ', '\t']);
        let (left, value) = line
            .split_once(['=', ':', ';', '\t', '|', ','])
            .or_else(|| line.rsplit_once(' '))?;
        let is_between_commas = line[left.len()..].starts_with(',');
        let (left, unit) = left.split_once(['[', '(']).unwrap_or((left, ""));
        // A column behind the numbers may have the unit.
        let (value, unit) = match value.split_once([';', '\t', '|', ',']) {
            Some((value, behind)) if is_unit(trimmed(behind)) => (value, behind),
            _ => (value, unit),
        };
        let left = trimmed(left);
        let mut signs = left.char_indices().filter(|(_, c)| !c.is_alphanumeric());
        let behind = signs
            .next_back()
            .map_or(0, |(at, sign)| at + sign.len_utf8());
        let (name, axis) = left.split_at(behind);
        // Between commas `130,2` may be two columns.
        let is_one = is_number(value) && !(is_between_commas && value.contains(','));
        is_one.then(|| Self {
            name: trimmed(name),
            axis,
            value: value.trim(),
            unit: trimmed(unit),
        })
    }
}

/// Returns a text without the signs around it.
fn trimmed(text: &str) -> &str {
    text.trim_matches(|c: char| !c.is_alphanumeric())
}
