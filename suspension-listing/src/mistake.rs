//! A mistake in a text, and its place.

use syn::Error;

use crate::errors;

/// A mistake at one place of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// The message: what is wrong, and what to write instead.
    pub message: String,
    /// The line, counted from 1.
    pub line: usize,
    /// The column in characters, counted from 1.
    pub column: usize,
    /// The number of characters of the line that it is about; zero if something is missing.
    pub length: usize,
}

impl Mistake {
    /// The message of an error, at its place in a text.
    pub(crate) fn new(text: &str, error: &Error) -> Self {
        let message = escape_control(&error.to_string());
        let (start, end) = (error.span().start(), error.span().end());
        // The parser gives no place for something that is missing at the end.
        if errors::is_from_parser(&message) && error.span().byte_range() == (0..0) {
            let lines = text.lines().count().max(1);
            let last = text.lines().last().map_or(0, |line| line.chars().count());
            return Self {
                message,
                line: lines,
                column: last + 1,
                length: 0,
            };
        }
        if errors::lacks_semicolon(&message) {
            return Self {
                message,
                line: end.line,
                column: end.column + 1,
                length: 0,
            };
        }
        let line = text.lines().nth(start.line.saturating_sub(1));
        let width = line.map_or(0, |line| line.chars().count());
        let to = if end.line == start.line {
            end.column
        } else {
            width
        };
        Self {
            message,
            line: start.line.max(1),
            column: start.column + 1,
            length: to.saturating_sub(start.column),
        }
    }
}

/// A message as a single line, with control characters escaped: the name of a file in it may have some.
pub fn escape_control(message: &str) -> String {
    let escaped = |character: char| {
        if character.is_control() {
            character.escape_default().to_string()
        } else {
            character.to_string()
        }
    };
    message.chars().map(escaped).collect()
}
