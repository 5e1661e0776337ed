//! The errors of the parser: which they are, and what takes their place.

use std::iter;

use proc_macro2::TokenTree;
use syn::buffer::Cursor;
use syn::spanned::Spanned;
use syn::{Attribute, Error};

/// Whether a message is the parser's own, which names what it expected.
pub(crate) fn is_from_parser(message: &str) -> bool {
    message.starts_with("expected") || message.starts_with("unexpected end")
}

/// Whether a message of the parser says that a statement does not end: its place is then behind the end.
pub(crate) fn lacks_semicolon(message: &str) -> bool {
    message.starts_with("expected `;`") || message.starts_with("expected `,` or `;`")
}

/// The error that a statement does not end, at the last token that was read as part of it.
pub(crate) fn at_statement_end(error: Error, begin: Cursor<'_>, end: Cursor<'_>) -> Error {
    let message = error.to_string();
    if !lacks_semicolon(&message) {
        return error;
    }
    let last = tokens(begin, end).last();
    Error::new(last.map_or(error.span(), |last| last.span()), message)
}

/// The tokens between two places of a text.
pub(crate) fn tokens<'a>(
    mut begin: Cursor<'a>,
    end: Cursor<'a>,
) -> impl Iterator<Item = TokenTree> + use<'a> {
    iter::from_fn(move || {
        let (token, next) = begin.token_tree().filter(|_| begin != end)?;
        begin = next;
        Some(token)
    })
}

/// The message for a name that is a keyword of Rust, which replaces that of `syn`.
pub(crate) fn keyword_as_name(message: &str) -> Option<String> {
    let behind = message.strip_prefix("expected identifier, found keyword `")?;
    let (word, _) = behind.split_once('`')?;
    Some(format!(
        "`{word}` is a keyword of Rust and cannot be a name; choose another, for example `{word}_`"
    ))
}

/// The error for what is no name, which replaces that of `syn`; that for a keyword stays.
pub(crate) fn no_name(error: Error) -> Error {
    if error.to_string() == "expected identifier" {
        let message =
            "expected a name, of letters, digits and `_`, that does not begin with a digit";
        Error::new(error.span(), message)
    } else {
        error
    }
}

pub(crate) fn not_a_doc_comment(attribute: &Attribute) -> Error {
    Error::new(
        attribute.span(),
        "only doc comments are allowed on statements; remove the attribute",
    )
}
