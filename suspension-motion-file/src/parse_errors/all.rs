//! All errors in a text at once. The parser of TOML reports each mistake in the notation; of those in keys and values serde
//! reports the first, so that the entry with it is left out and the rest is read again.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::ops::Range;

use serde::de::DeserializeOwned;
use toml::Spanned;
use toml::de::{DeTable, DeValue, Deserializer, Error};

use crate::failure::MOST_MISTAKES;

/// The name of an entry after the names of the tables that it is in; empty for the whole text.
type Path = Vec<String>;

/// Returns the errors of a text that cannot be read as a `T`, in their order in the text.
pub(super) fn all<T: DeserializeOwned>(text: &str) -> Vec<Error> {
    let (table, errors) = DeTable::parse_recoverable(text);
    if !errors.is_empty() {
        return in_notation(text, errors);
    }
    let mut errors = in_entries::<T>(table);
    errors.sort_by_key(start);
    // Several unknown fields in one line are one other notation, as { x = 0.1, y = 0.2, z = 0.3 }.
    let is_unknown = |error: &Error| error.message().starts_with("unknown field");
    errors.dedup_by(|next, first| {
        let are_unknown = is_unknown(first) && is_unknown(next);
        are_unknown && !text[start(first)..start(next)].contains('\n')
    });
    errors
}

fn start(error: &Error) -> usize {
    error.span().map_or(0, |span| span.start)
}

/// Of the errors in one line the first, from which the others may follow.
fn in_notation(text: &str, mut errors: Vec<Error>) -> Vec<Error> {
    let line_ends: Vec<usize> = text.match_indices('\n').map(|(end, _)| end).collect();
    let line = |error: &Error| line_ends.partition_point(|end| *end < start(error));
    let lacks_equals = |error: &&Error| error.message().starts_with("key with no value");
    let lines = errors.iter().filter(lacks_equals).map(line).collect();
    errors.extend(DeTable::parse_recoverable(&without(&lines, text)).1);
    errors.sort_by_key(line);
    errors.dedup_by_key(|error| line(error));
    if let Some(open) = errors.iter().position(leaves_open) {
        errors.truncate(open + 1);
    }
    errors
}

/// The text with blanks in place of lines without `=`, behind the first of which the parser reads no values.
fn without(lines: &BTreeSet<usize>, text: &str) -> String {
    let all = text.split_inclusive('\n').enumerate();
    let kept = all.map(|(number, line)| match lines.contains(&number) {
        true => Cow::from(" ".repeat(line.len() - 1) + "\n"),
        false => Cow::from(line),
    });
    kept.collect()
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
