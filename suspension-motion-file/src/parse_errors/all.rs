//! All errors in a text at once. The parser of TOML reports each mistake in the notation; of those in keys and values serde
//! reports the first, so that the entry with it is left out and the rest is read again.

use std::ops::Range;

use serde::de::DeserializeOwned;
use toml::Spanned;
use toml::de::{DeTable, DeValue, Deserializer, Error};

use crate::failure::MOST_MISTAKES;

/// The name of an entry after the names of the tables that it is in; empty for the whole text.
type Path = Vec<String>;

/// Returns the errors of a text that is no `T`, at most [`MOST_MISTAKES`], in their order in the text; of those in one line the
/// first, from which the others may follow.
pub(super) fn all<T: DeserializeOwned>(text: &str) -> Vec<Error> {
    let (table, mut errors) = DeTable::parse_recoverable(text);
    let is_table = errors.is_empty();
    if is_table {
        errors = in_entries::<T>(table);
    }
    let line_ends: Vec<usize> = text.match_indices('\n').map(|(end, _)| end).collect();
    let line = |error: &Error| {
        let start = error.span().map_or(0, |span| span.start);
        line_ends.partition_point(|end| *end < start)
    };
    errors.sort_by_key(line);
    errors.dedup_by_key(|error| line(error));
    if let Some(open) = errors.iter().position(leaves_open).filter(|_| !is_table) {
        errors.truncate(open + 1);
    }
    errors.truncate(MOST_MISTAKES);
    errors
}

/// Whether the parser may have read what follows as part of an earlier value.
fn leaves_open(error: &Error) -> bool {
    let within = [
        "array",
        "inline table",
        "key-value pairs",
        "multi-line",
        "recurse",
    ];
    within.iter().any(|words| error.message().contains(words))
}

fn in_entries<T: DeserializeOwned>(mut table: Spanned<DeTable<'_>>) -> Vec<Error> {
    let mut errors = Vec::new();
    let mut left_out: Vec<Path> = Vec::new();
    while errors.len() < MOST_MISTAKES
        && let Err(error) = T::deserialize(Deserializer::from(table.clone()))
    {
        // The place of the whole text is empty.
        let place = error.span().filter(|place| !place.is_empty());
        let path = place.map_or(Path::new(), |place| take_out(table.get_mut(), &place));
        if !follows(&error, &path, &left_out) {
            errors.push(error);
        }
        if path.is_empty() {
            break;
        }
        left_out.push(path);
    }
    errors
}

/// Whether a field is missing in the entry at `path` because one was left out of it, or because it was in another table.
fn follows(error: &Error, path: &[String], left_out: &[Path]) -> bool {
    let message = error.message();
    let Some(quoted) = message.strip_prefix("missing field `") else {
        return false;
    };
    let missing = quoted.split('`').next();
    left_out.iter().any(|other| {
        let was_in_it = other.len() == path.len() + 1 && other.starts_with(path);
        was_in_it || other.last().map(String::as_str) == missing
    })
}

/// Takes the innermost entry that has a place within it out of a table.
fn take_out(table: &mut DeTable<'_>, place: &Range<usize>) -> Path {
    for (name, value) in table.iter_mut() {
        if let DeValue::Table(inner) = value.get_mut() {
            let rest = take_out(inner, place);
            if !rest.is_empty() {
                return [vec![name.get_ref().to_string()], rest].concat();
            }
        }
    }
    let has = |span: Range<usize>| span.start <= place.start && place.end <= span.end;
    let mut entries = table.iter();
    let found = entries.find(|(name, value)| has(name.span()) || has(value.span()));
    let Some((name, _)) = found else {
        return Path::new();
    };
    let name = name.get_ref().to_string();
    table.remove(name.as_str());
    vec![name]
}
