//! Errors of the TOML parser for a motion file, with what to write instead.

mod all;
mod syntax;

use std::collections::HashSet;

use serde::de::DeserializeOwned;
use suspension_listing::did_you_mean::did_you_mean;
use toml::de::Error;

use crate::failure::Failure;
use crate::other_names::key_meant;
use crate::place_of_key::place_among_keys;
use crate::source::Source;

/// Returns the failure for a file that cannot be read as a `T`, with all its mistakes. A list of the known keys or words is in the first
/// message to which it belongs, and not repeated.
pub(super) fn refused<T: DeserializeOwned>(source: &Source) -> Failure {
    let errors = all::all::<T>(source.text());
    let place = |error: &Error| error.span().unwrap_or(0..0);
    if let Some(message) = other_kind(source) {
        return source.refuse(&errors.first().map_or(0..0, place), message);
    }
    let mut listed = HashSet::new();
    source.refuse_all(&errors, |error| {
        let place = place(error);
        let message = explained(error.message(), source, place.start);
        match message.split_once(", expected one of") {
            Some((mistake, known)) if !listed.insert(known.to_owned()) => {
                (place, mistake.to_owned())
            }
            _ => (place, message),
        }
    })
}

/// Returns the message for a mistake that begins at `start`.
fn explained(message: &str, source: &Source, start: usize) -> String {
    if let Some(mistake) = syntax::explained(message, source.text(), start) {
        return mistake;
    }
    let message = message.trim_end().replace('\n', ", ");
    let message = WORDS.iter().fold(message, |message, [of_parser, ours]| {
        message.replace(of_parser, ours)
    });
    // With a suggestion, or in a known table, the list of all expected keys is omitted: it may be long.
    match (
        message.split_once(", expected"),
        hint(&message, source, start),
    ) {
        (Some((unknown, _)), hint) if unknown.starts_with("unknown field") && !hint.is_empty() => {
            unknown.to_owned() + &hint
        }
        (_, hint) => message + &hint,
    }
}

/// Words of the parser, each with the one for authors of files.
const WORDS: [[&str; 2]; 6] = [
    ["expected f64", "expected a number"],
    ["expected a sequence", "expected a list in brackets, [...]"],
    ["expected a string", "expected a text in quotes"],
    ["type: sequence", "type: list"],
    ["type: map", "type: table"],
    ["unknown variant", "unknown word"],
];

/// Says what to write in place of a mistake that begins at `start`; empty if that is unknown.
fn hint(message: &str, source: &Source, start: usize) -> String {
    let mut quoted = message.split('`').skip(1).step_by(2);
    let name = quoted.next().unwrap_or_default();
    let rest = source.text().get(start..).unwrap_or_default();
    if message.starts_with("unknown field") {
        if let Some(key) = key_meant(name, quoted.clone()) {
            return format!("; did you mean `{key}`?");
        }
        if quoted.clone().eq(["from", "offset"]) && ["x", "y", "z"].contains(&name) {
            return "; coordinates are written [x, y, z]".to_owned();
        }
        match (joined(name, source.text(), start), place_among_keys(name)) {
            (Some(joined), _) if quoted.clone().eq(["force", "moment"]) => {
                format!("; a part of a named wheel or side is written {joined}")
            }
            (_, Some(place)) => format!("; {name} belongs {place}"),
            _ if ["track", "track_width"].contains(&name) => {
                "; the track follows from the points of the wheels".to_owned()
            }
            (_, None) => did_you_mean(name, quoted),
        }
    } else if message.starts_with("unknown word") {
        match symbol_meant(name).filter(|symbol| quoted.clone().any(|known| known == *symbol)) {
            Some(symbol) => format!("; write \"{symbol}\""),
            None => did_you_mean(name, quoted),
        }
    } else if let Some(number) = number_in_quotes(message) {
        format!("; write {number} without quotes")
    } else if message.starts_with("missing field") {
        example_of_key(name).to_owned() + &also_missing(name, source.text())
    } else if message.starts_with("invalid type: string")
        && ["unit", "angle", "axes"].contains(&key_at(source.text(), start))
    {
        "; unit, angle and axes belong above the first table".to_owned()
    } else if message.starts_with("invalid type") && !message.contains(": write") {
        let example = example_of_key(key_at(source.text(), start));
        let list = list_of_one(message, rest).filter(|_| example.is_empty());
        list.unwrap_or_else(|| example.to_owned())
    } else {
        String::new()
    }
}

/// Returns the key whose value begins at `start`, or has an entry of its list there; empty if there is none.
fn key_at(text: &str, start: usize) -> &str {
    let (before, rest) = text.split_at_checked(start).unwrap_or((text, ""));
    let is_end = |letter: char| !letter.is_alphanumeric() && letter != '_';
    let is_header = before.is_empty() || before.ends_with('\n');
    if let Some(header) = rest.strip_prefix("[[").filter(|_| is_header) {
        let name = header.split(']').next().unwrap_or_default();
        return name.rsplit('.').next().unwrap_or_default();
    }
    let (key, value) = before.rsplit_once('=').unwrap_or_default();
    let is_within = value.trim().is_empty() || value.trim_start().starts_with('[');
    let is_open = is_within && !value.contains([']', '{']);
    let mut words = key.trim_end().rsplit(is_end).filter(|_| is_open);
    words.next().unwrap_or_default()
}

/// Says how a single value is written as the list that is expected.
fn list_of_one(message: &str, rest: &str) -> Option<String> {
    let value = rest.split([',', ']', '}', '\n', '#']).next()?.trim();
    let is_one = message.contains("expected a list") && !value.starts_with(['{', '[']);
    is_one.then(|| format!("; write [{value}]"))
}

/// Returns a name that begins at `start` with the one before it and its point, `left.contact`, as one name.
fn joined(name: &str, text: &str, start: usize) -> Option<String> {
    let before = text.get(..start)?.strip_suffix('.')?;
    let is_end = |letter: char| !letter.is_alphanumeric() && letter != '_';
    Some(format!("{}_{name}", before.rsplit(is_end).next()?))
}

/// Returns the number that stands in quotes where one is expected.
fn number_in_quotes(message: &str) -> Option<&str> {
    let text = message.strip_prefix("invalid type: string \"")?;
    let (text, expected) = text.split_once('"')?;
    let is_number = expected.starts_with(", expected a number") && text.parse::<f64>().is_ok();
    is_number.then_some(text)
}

/// Returns the symbol of a unit that is written as a word.
fn symbol_meant(word: &str) -> Option<&'static str> {
    match word.to_lowercase().trim_end_matches('s') {
        "meter" | "metre" => Some("m"),
        "millimeter" | "millimetre" => Some("mm"),
        "inch" | "inche" => Some("in"),
        "degree" => Some("deg"),
        "radian" => Some("rad"),
        _ => None,
    }
}

/// Names the other required keys that are missing, which the parser would report one at a time.
fn also_missing(first: &str, text: &str) -> String {
    const NEEDED: [&str; 3] = ["unit", "time", "drives"];
    let table: toml::Table = text.parse().unwrap_or_default();
    let is_missing = |name: &str| NEEDED.contains(&name) && !table.contains_key(name);
    let others = NEEDED
        .iter()
        .filter(|name| **name != first && is_missing(first) && is_missing(name));
    let hints = others.map(|name| format!("; missing field `{name}`{}", example_of_key(name)));
    hints.collect()
}

/// Returns an example of a missing key.
fn example_of_key(key: &str) -> &'static str {
    match key {
        "unit" => "; write unit = \"m\", \"mm\" or \"in\", the unit of all lengths in the file",
        "time" => "; write [time] with start, stop and step, or with instants, in seconds",
        "springs" => "; write [springs.NAME] with along and rate",
        "loads" => "; write [loads.NAME] with a line for each load, see suspension loads --help",
        "over" => "; write the range from the design position, as over = { bump = [-0.05, 0.05] }",
        "targets" => "; write [tune.targets.NAME], see suspension tune --help",
        "moves" => "; write [tune.moves.NAME], see suspension tune --help",
        "by" => "; write the box, from the least to the greatest, as by = [-0.010, 0.010]",
        "of" => "; write the name of a quantity, as of = \"toe\"",
        "within" => "; write how far the target may be off, as within = 0.001",
        "along" => {
            "; write the name of the measure that the spring acts along, as along = \"damper\""
        }
        "rate" => "; write it in N per unit of length, or for an angle in N m per unit of angle",
        "mean" => "; write the value about which the drive moves, as mean = 0.30",
        "amplitude" => "; write half of the distance between the ends, as amplitude = 0.05",
        "csv" => "; write the path of the file, as csv = \"logged.csv\"",
        "columns" => "; write the headings of its two columns, as columns = [\"NAME\", \"NAME\"]",
        "centre" => "; write a point or coordinates, as centre = \"wheel_centre\"",
        "mass" => "; write it in kg, as mass = 25.0",
        "inertia" => "; write the moments of inertia in kg m^2, as inertia = [0.8, 1.2, 0.8]",
        "from" => "; write the name of another point, as from = \"wheel_centre\"",
        "frequency" => "; write it in Hz, as frequency = 1.5",
        "drives" => "; write [drives] with a line for each drive, as bump = [0.30, 0.05]",
        _ => "",
    }
}

/// Says what to do with a file of another kind.
fn other_kind(source: &Source) -> Option<String> {
    if source.text().trim().is_empty() {
        let empty = "the file is empty; suspension motion --help shows what a motion file contains";
        return Some(empty.to_owned());
    }
    if source.text().trim_start().starts_with('{') {
        let json = "this is JSON; a motion file is in TOML, as suspension motion --help shows";
        return Some(json.to_owned());
    }
    let is_listing = is_listing(source.text());
    let name = source.name();
    let endings = [".csv", ".sub", ".shk", ".txt"];
    let has_hardpoints = endings
        .iter()
        .any(|ending| name.to_lowercase().ends_with(ending));
    if is_listing {
        Some("this is a listing; a motion file names it: listing = \"FILE\", with unit, [time] and [drives]".to_owned())
    } else {
        has_hardpoints.then(|| {
            "this is not a motion file; suspension import makes one from hardpoints".to_owned()
        })
    }
}

/// Returns whether a text looks like a listing that is not in a motion file.
pub fn is_listing(text: &str) -> bool {
    let mut lines = text.lines().map(str::trim_start);
    let begins = |line: &str| line.starts_with("fixed:") || line.starts_with("free:");
    !is_motion(text) && lines.any(begins)
}

/// Returns whether a text has keys of a motion file.
pub fn is_motion(text: &str) -> bool {
    let keys = text.lines().filter_map(|line| line.split_once('='));
    let mut keys = keys.map(|(key, _)| key.trim());
    keys.any(|key| ["linkage", "listing", "statements"].contains(&key))
}
