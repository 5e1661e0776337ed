//! Listings as text: the statements as they stand inside the module's braces, from a file or from a
//! string, with all that is wrong with them as data.
//!
//! Places in the text are read off spans of `proc-macro2`, of which each thread has a table. It is
//! emptied after each listing: what else a thread has parsed with `proc-macro2` loses its places.

mod limits;

use std::fmt;

use proc_macro2::{LexError, Span, TokenStream};
use syn::Error;
use syn::parse::{ParseStream, Parser};

use crate::kind::Kind;
use crate::name::Name;
use crate::system::System;
use crate::{checked, parse};

pub use limits::{
    DEEPEST, LONGEST_NUMBER, MOST_BYTES, MOST_POINTS, MOST_STATEMENTS, MOST_UNKNOWNS,
};

/// What is wrong at one place of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// What is wrong, and what to write instead.
    pub message: String,
    /// Counted from 1.
    pub line: usize,
    /// In characters, counted from 1.
    pub column: usize,
    /// How many characters of the line it is about; zero where something is missing.
    pub length: usize,
}

/// All that is wrong with a text, one line each.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistakes {
    /// Where the text is from.
    pub file: String,
    /// In the order found; at least one.
    pub mistakes: Vec<Mistake>,
}

impl fmt::Display for Mistakes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, mistake) in self.mistakes.iter().enumerate() {
            let Mistake {
                message,
                line,
                column,
                ..
            } = mistake;
            let end = if index == 0 { "" } else { "\n" };
            write!(f, "{end}{}:{line}:{column}: {message}", self.file)?;
        }
        Ok(())
    }
}

impl std::error::Error for Mistakes {}

/// The system of a text that is read at run time. `file` is where it is from, for messages.
///
/// # Errors
///
/// All mistakes, and what exceeds [`MOST_BYTES`], [`MOST_STATEMENTS`], [`MOST_POINTS`],
/// [`MOST_UNKNOWNS`], [`DEEPEST`] or [`LONGEST_NUMBER`].
pub fn parse(text: &str, file: &str) -> Result<System, Mistakes> {
    let read = limits::length(text).map_or_else(
        |mistake| Err(vec![mistake]),
        |()| {
            let read = front(text, true);
            match read.system.filter(|_| read.mistakes.is_empty()) {
                Some(system) => Ok(system),
                None => Err(read.mistakes),
            }
        },
    );
    read.map_err(|mistakes| Mistakes {
        file: file.to_owned(),
        mistakes,
    })
}

/// What is told of a text.
pub struct Read {
    /// Of a text with mistakes what can be told.
    pub system: Option<System>,
    /// The names that it declares.
    pub names: Vec<(Name, Kind)>,
    pub mistakes: Vec<Mistake>,
}

/// Reads a text of any size, as the macro does.
pub fn read(text: &str) -> Read {
    front(text, false)
}

fn front(text: &str, bounded: bool) -> Read {
    let listing = tokens(text).and_then(|tokens| {
        let statements = |input: ParseStream<'_>| parse::statements(input, Span::call_site());
        let (listing, errors) = statements.parse2(tokens).map_err(|e| mistakes(text, e))?;
        if bounded {
            limits::listing(&listing).map_err(|e| mistakes(text, e))?;
        }
        Ok((listing, errors))
    });
    let read = match listing {
        Ok((listing, errors)) => {
            let (system, found) = checked(&listing, errors);
            let found = match found {
                Ok(()) if bounded => limits::unknowns(&listing, system.size()),
                found => found,
            };
            Read {
                system: Some(system),
                names: listing.names(),
                mistakes: found.err().map_or_else(Vec::new, |e| mistakes(text, e)),
            }
        }
        Err(mistakes) => Read {
            system: None,
            names: Vec::new(),
            mistakes,
        },
    };
    proc_macro2::extra::invalidate_current_thread_spans();
    read
}

fn tokens(text: &str) -> Result<TokenStream, Vec<Mistake>> {
    let tokens: TokenStream = text.parse().map_err(|e| vec![unreadable(text, &e)])?;
    match limits::tokens(&tokens) {
        Some(error) => Err(mistakes(text, error)),
        None => Ok(tokens),
    }
}

fn unreadable(text: &str, error: &LexError) -> Mistake {
    let start = error.span().start();
    let line = text.lines().nth(start.line.saturating_sub(1));
    let rest = line.map_or("", |line| {
        let start = line.char_indices().nth(start.column);
        start.map_or("", |(byte, _)| &line[byte..])
    });
    let message = match rest.chars().next() {
        Some(bracket @ ('(' | '[' | '{')) => format!("`{bracket}` is not closed; close it"),
        Some(bracket @ (')' | ']' | '}')) => format!("`{bracket}` closes nothing; remove it"),
        Some(other) => format!("what begins with `{other}` cannot be read; remove it"),
        None => "the text ends too early".to_owned(),
    };
    Mistake {
        message,
        line: start.line.max(1),
        column: start.column + 1,
        length: usize::from(!rest.is_empty()),
    }
}

fn mistakes(text: &str, error: Error) -> Vec<Mistake> {
    error
        .into_iter()
        .map(|error| mistake(text, &error))
        .collect()
}

fn mistake(text: &str, error: &Error) -> Mistake {
    let message = error.to_string();
    let (start, end) = (error.span().start(), error.span().end());
    // The parser has no place for what is missing at the end.
    if parse::is_of_the_parser(&message) && error.span().byte_range() == (0..0) {
        let lines = text.lines().count().max(1);
        let last = text.lines().last().map_or(0, |line| line.chars().count());
        return Mistake {
            message,
            line: lines,
            column: last + 1,
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
    Mistake {
        message,
        line: start.line.max(1),
        column: start.column + 1,
        length: to.saturating_sub(start.column),
    }
}
