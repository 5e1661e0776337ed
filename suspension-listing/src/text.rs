//! Listings as text: the statements inside the module's braces, from a file or a
//! string, and all mistakes in them as data.
//!
//! Places in the text are those of spans of `proc-macro2`, of which each thread has a table. The table is
//! emptied after each listing: other text that a thread has parsed with `proc-macro2` loses its places.

mod limits;

use std::fmt;

use proc_macro2::Span;
use syn::parse::{ParseStream, Parser};

use crate::include::{IncludeSource, mistakes};
use crate::kind::Kind;
use crate::lexed::{tokens, with_lexer_places};
use crate::name::Name;
use crate::system::System;
use crate::{checked, flat, parse};

pub use crate::lexed::{DEEPEST, LONGEST_NUMBER, MOST_BYTES};
pub use crate::mistake::{Mistake, escape_control};
pub use limits::{MOST_POINTS, MOST_STATEMENTS, MOST_UNKNOWNS, too_many};

/// All mistakes in a text, printed one per line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistakes {
    /// The source of the text.
    pub file: String,
    /// The mistakes in the order found; at least one.
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

/// The system of a text that is read at run time. `file` is the source of the text, for messages; `includes` provides
/// the texts that it includes.
///
/// # Errors
///
/// All mistakes, and anything that exceeds [`MOST_BYTES`], [`MOST_STATEMENTS`], [`MOST_POINTS`], [`MOST_UNKNOWNS`],
/// [`DEEPEST`] or [`LONGEST_NUMBER`].
pub fn parse(text: &str, file: &str, includes: &dyn IncludeSource) -> Result<System, Mistakes> {
    let read = limits::length(text).map_or_else(
        |mistake| Err(vec![mistake]),
        |()| {
            let read = with_lexer_places(|| front(text, true, includes));
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

/// The statements of a text with its includes and mirrors written out, one below the other, so that the text needs no other
/// file. Each point, also a marker, has the position `at` its name, or none where `at` gives none. The text declares the
/// same names in the same order.
///
/// # Errors
///
/// The mistakes of statements that cannot be read, in a text of any size. What else [`parse`](fn@parse) checks is not checked.
pub fn flat(
    text: &str,
    file: &str,
    includes: &dyn IncludeSource,
    at: &dyn Fn(&str) -> Option<[f64; 3]>,
) -> Result<String, Mistakes> {
    parsed(text, file, |input| flat::printed(input, includes, at))
}

/// The names that a text declares, and their kinds: points first, then in the order stated.
///
/// # Errors
///
/// The mistakes of statements that cannot be read, in a text of any size. What else [`parse`](fn@parse) checks is not checked.
pub fn declared(
    text: &str,
    file: &str,
    includes: &dyn IncludeSource,
) -> Result<Vec<(Name, Kind)>, Mistakes> {
    parsed(text, file, |input| {
        let (listing, errors) = parse::statements(input, Span::call_site(), includes)?;
        errors.into_result()?;
        Ok(listing.names())
    })
}

/// What a parser makes of a text.
fn parsed<R>(
    text: &str,
    file: &str,
    parser: impl FnOnce(ParseStream<'_>) -> syn::Result<R>,
) -> Result<R, Mistakes> {
    let parsed = with_lexer_places(|| {
        let tokens = tokens(text)?;
        let parsed = parser.parse2(tokens);
        parsed.map_err(|error| mistakes(text, &[], error))
    });
    proc_macro2::extra::invalidate_current_thread_spans();
    parsed.map_err(|mistakes| Mistakes {
        file: file.to_owned(),
        mistakes,
    })
}

/// The result of reading a text.
pub struct Read {
    /// The system; for a text with mistakes as far as it can be determined.
    pub system: Option<System>,
    /// The names that it declares.
    pub names: Vec<(Name, Kind)>,
    pub mistakes: Vec<Mistake>,
}

/// Reads a text of any size, as the macro does.
pub fn read(text: &str, includes: &dyn IncludeSource) -> Read {
    with_lexer_places(|| front(text, false, includes))
}

fn front(text: &str, bounded: bool, includes: &dyn IncludeSource) -> Read {
    let listing = tokens(text).and_then(|tokens| {
        let statements =
            |input: ParseStream<'_>| parse::statements(input, Span::call_site(), includes);
        let (listing, errors) = statements
            .parse2(tokens)
            .map_err(|e| mistakes(text, &[], e))?;
        if bounded {
            limits::listing(&listing).map_err(|e| mistakes(text, &[], e))?;
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
                mistakes: found
                    .err()
                    .map_or_else(Vec::new, |e| mistakes(text, &listing.included, e)),
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
