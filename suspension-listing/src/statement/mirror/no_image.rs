//! Quantities of which the exchange of names makes no image.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use syn::{Error, Ident};

use crate::errors;
use crate::lexed::is_punct;

/// The error for a statement with such a quantity.
pub(super) fn without_image(tokens: &[TokenTree]) -> Option<Error> {
    let sum = y_beside_others(tokens).map(mixed);
    sum.or_else(|| tokens.iter().find_map(y_of_angle).map(|y| from_y(&y)))
}

/// The y in a sum that also has other coordinates.
fn y_beside_others(tokens: &[TokenTree]) -> Option<&Ident> {
    let axes = tokens.windows(2).filter_map(|pair| match pair {
        [dot, TokenTree::Ident(axis)] if is_punct(dot, '.') => Some(axis),
        _ => None,
    });
    let (y, others): (Vec<&Ident>, Vec<&Ident>) = axes.partition(|axis| *axis == "y");
    y.first().copied().filter(|_| !others.is_empty())
}

/// The y of `(p -> q, y)`.
fn y_of_angle(token: &TokenTree) -> Option<Ident> {
    let content = match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis => group.stream(),
        _ => TokenStream::new(),
    };
    let content: Vec<TokenTree> = content.into_iter().collect();
    match content.as_slice() {
        [.., comma, TokenTree::Ident(axis)] if is_punct(comma, ',') => {
            (axis == "y").then(|| axis.clone())
        }
        _ => None,
    }
}

fn mixed(y: &Ident) -> Error {
    errors::at(
        y,
        "`mirror` makes no image of a sum of y with x or z, whose y would change its sign; state it for each side, under \
         names without the words that are exchanged",
    )
}

fn from_y(y: &Ident) -> Error {
    errors::at(
        y,
        "`mirror` makes no image of an angle from y, which would become pi minus the angle; state it for each side, under \
         names without the words that are exchanged, with the line reversed on one side",
    )
}
