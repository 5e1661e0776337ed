//! The texts that a listing includes, and the mistakes in them and in the listing.

use proc_macro2::{Span, TokenStream};
use syn::Error;

use crate::mistake::Mistake;

/// An included text, for the places of its mistakes.
#[derive(Clone)]
pub(crate) struct Included {
    name: String,
    /// The place where it is named.
    place: Span,
    /// The name that the lexer gives it.
    file: Option<String>,
    text: String,
}

impl Included {
    /// An included text that is named at a place, with its `tokens`.
    pub(crate) fn new(
        name: String,
        place: Span,
        text: String,
        tokens: Option<&TokenStream>,
    ) -> Self {
        let first = tokens.and_then(|tokens| tokens.clone().into_iter().next());
        let file = first.map(|token| token.span().file());
        Self {
            name,
            place,
            // Under a fuzzer the lexer gives all texts the same name, so the place that names this one would seem to
            // lie in it.
            file: file.filter(|file| *file != place.file()),
            text,
        }
    }

    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// Whether a place is in it.
    fn has(&self, place: Span) -> bool {
        self.file == Some(place.file())
    }

    /// The error with its mistakes, at the place where it is named.
    pub(crate) fn wrong(&self, mistakes: Vec<Mistake>) -> Error {
        let name = &self.name;
        let refused = |message| Error::new(self.place, message);
        let mut errors = mistakes.into_iter().map(|mistake| {
            let Mistake {
                line,
                column,
                message,
                ..
            } = mistake;
            refused(format!("{name}:{line}:{column}: {message}"))
        });
        let first = errors.next();
        let first = first.unwrap_or_else(|| refused(format!("`{name}` cannot be read")));
        errors.fold(first, |mut all, error| {
            all.combine(error);
            all
        })
    }
}

/// All mistakes, each at its place; those in an included text also at the place where that is included.
pub(crate) fn mistakes(text: &str, included: &[Included], error: Error) -> Vec<Mistake> {
    let mistake_of = |error: Error| {
        let inner = included.iter().find(|inner| inner.has(error.span()));
        let mistake = Mistake::new(inner.map_or(text, |inner| &inner.text), &error);
        match inner {
            Some(inner) => mistakes(text, included, inner.wrong(vec![mistake])),
            None => vec![mistake],
        }
    };
    error.into_iter().flat_map(mistake_of).collect()
}
