//! The texts that a listing includes, and the mistakes in them and in the listing.

use proc_macro2::{Span, TokenStream};
use syn::Error;

use crate::mistake::Mistake;

/// A text that was included, for the places of what is wrong in it.
#[derive(Clone)]
pub(crate) struct Included {
    name: String,
    /// Where it is named.
    place: Span,
    /// What the lexer calls it.
    file: Option<String>,
    text: String,
}

impl Included {
    /// One that is named at a place, as `tokens`.
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
            // Under a fuzzer the lexer calls all texts the same, and what names this one would lie in it.
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

    /// What is wrong in it, where it is named.
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

/// All that is wrong, each at its place; what is wrong in an included text also where that is included.
pub(crate) fn mistakes(text: &str, included: &[Included], error: Error) -> Vec<Mistake> {
    let mistake_of = |error: Error| {
        let inner = included.iter().find(|inner| inner.has(error.span()));
        let mistake = Mistake::of(inner.map_or(text, |inner| &inner.text), &error);
        match inner {
            Some(inner) => mistakes(text, included, inner.wrong(vec![mistake])),
            None => vec![mistake],
        }
    };
    error.into_iter().flat_map(mistake_of).collect()
}
