//! Commands of Adams/View in which points are made: `point create point_name = .car.hpl_lca_front location = 1, 2, 3`.

use crate::commands::import::format::fields::is_number;
use crate::commands::import::format::lines::{Line, Placed};

/// The sign at the end of a line that goes on in the next one.
const GOES_ON: char = '&';

/// Joins lines that go on, and puts the name and the coordinates in place of a command with `location`. A part of a row in
/// LaTeX goes on in the same way.
pub(super) fn with_commands_as_rows<'a>(
    lines: impl Iterator<Item = Placed<&'a str>>,
) -> Vec<Line<'a>> {
    let mut rows: Vec<Line<'a>> = Vec::new();
    let mut goes_on = false;
    for (place, line) in lines {
        match rows.last_mut().filter(|_| goes_on) {
            Some((whole, before)) => {
                whole.end = place.end;
                before.to_mut().push_str(line);
            }
            None => rows.push((place, line.into())),
        }
        goes_on = line.trim_end().ends_with(GOES_ON);
    }
    for (_, line) in &mut rows {
        if let Some(row) = row_of(&line.replace(GOES_ON, " ")) {
            *line = row.into();
        }
    }
    rows
}

/// Returns `name; x; y; z` of a command that states a name and a location.
fn row_of(line: &str) -> Option<String> {
    let parameters: Vec<(&str, &str)> = parameters(line);
    let value = |of: &dyn Fn(&str) -> bool| {
        let found = parameters.iter().find(|(name, _)| of(name));
        found.map(|(_, value)| *value)
    };
    let name = value(&|name| name.ends_with("_name"))?;
    let location: Vec<&str> = value(&|name| name == "location")?
        .split(',')
        .map(str::trim)
        .collect();
    let [x, y, z] = location[..] else { return None };
    let is_point = [x, y, z].into_iter().all(is_number);
    is_point.then(|| format!("{name}; {x}; {y}; {z}"))
}

/// Returns the names and values of `name = value` in a command.
fn parameters(line: &str) -> Vec<(&str, &str)> {
    let parts: Vec<&str> = line.split('=').collect();
    let pairs = parts.windows(2).enumerate().filter_map(|(at, pair)| {
        let name = pair[0].split_whitespace().next_back()?;
        // The name of the next parameter stands behind the value.
        let value = pair[1].trim();
        let is_last = at + 2 == parts.len();
        let value = match value.rfind(char::is_whitespace).filter(|_| !is_last) {
            Some(end) => value[..end].trim(),
            None => value,
        };
        Some((name, value))
    });
    pairs.collect()
}
