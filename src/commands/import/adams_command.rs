//! Commands of Adams/View in which points are made: `point create point_name = .car.hpl_lca_front location = 1, 2, 3`.

use std::borrow::Cow;
use std::ops::Range;

use super::fields::is_number;

/// The sign at the end of a line that goes on in the next one.
const GOES_ON: char = '&';

/// Joins lines that go on, and puts the name and the coordinates in place of a command with `location`. A part of a row in
/// LaTeX goes on in the same way.
pub(super) fn with_commands_as_rows<'a>(
    lines: impl Iterator<Item = (Range<usize>, &'a str)>,
) -> impl Iterator<Item = (Range<usize>, Cow<'a, str>)> {
    let mut open: Option<(usize, String)> = None;
    lines.filter_map(move |(place, line)| {
        let goes_on = line.trim_end().ends_with(GOES_ON);
        let (start, line) = match open.take() {
            Some((start, before)) => (start, Cow::from(before + line)),
            None => (place.start, Cow::from(line)),
        };
        if goes_on {
            open = Some((start, line.into_owned()));
            return None;
        }
        let row = row_of(&line).map(Cow::from);
        Some((start..place.end, row.unwrap_or(line)))
    })
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
    let is_apart = |c: char| c.is_whitespace() || c == GOES_ON;
    let parts: Vec<&str> = line.split('=').collect();
    let pairs = parts.windows(2).enumerate().filter_map(|(at, pair)| {
        let name = pair[0].trim_end_matches(is_apart).rsplit(is_apart).next()?;
        // The name of the next parameter stands behind the value.
        let value = pair[1].trim_matches(is_apart);
        let is_last = at + 2 == parts.len();
        let value = match value.rfind(is_apart).filter(|_| !is_last) {
            Some(end) => value[..end].trim_matches(is_apart),
            None => value,
        };
        Some((name, value))
    });
    pairs.collect()
}
