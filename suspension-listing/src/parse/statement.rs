//! One statement.

use proc_macro2::{Punct, Spacing, TokenTree};
use syn::buffer::Cursor;
use syn::parse::ParseStream;
use syn::{Ident, Token};

use crate::did_you_mean::did_you_mean;
use crate::errors;
use crate::lexed::is_punct;
use crate::listing::Listing;
use crate::statement::STATEMENTS;
use crate::statement::operands::{docs, first_word};
use crate::statement::word::{Head, Word};

/// The tokens of the statement that was read from `begin` to `end`, with its semicolon even if it lacks that.
pub(super) fn tokens(begin: Cursor<'_>, end: Cursor<'_>) -> Vec<TokenTree> {
    let mut tokens = errors::tokens(begin, end).collect::<Vec<_>>();
    if !tokens.last().is_some_and(|last| is_punct(last, ';')) {
        tokens.push(Punct::new(';', Spacing::Alone).into());
    }
    tokens
}

/// Reads a statement into a listing.
pub(super) fn statement(input: ParseStream<'_>, listing: &mut Listing) -> syn::Result<()> {
    let docs = docs(input)?;
    let word: Ident = input.parse().map_err(|error| no_statement(&error))?;
    let Some(statement) = known(&word) else {
        // The name may be the word of a statement.
        input.parse::<Option<Ident>>()?;
        return Err(unknown_statement(&word));
    };
    let begin = input.cursor();
    let read = (statement.read)(Head { docs, word }, input, listing);
    read.and_then(|()| input.parse::<Token![;]>().map(drop))
        .map_err(|error| errors::at_statement_end(error, begin, input.cursor()))
        .map_err(|error| with_example(error, statement))
        .map_err(|error| with_spelling(error, input))
}

/// The statement that begins with this word.
fn known(word: &Ident) -> Option<&'static Word> {
    STATEMENTS.iter().find(|statement| word == statement.word)
}

/// The error for something that begins no statement, for example a second `;`.
fn no_statement(error: &syn::Error) -> syn::Error {
    let message = format!(
        "no statement begins like this; remove it, or write one of {}",
        words()
    );
    syn::Error::new(error.span(), message)
}

/// The words with which statements begin.
fn words() -> String {
    let words = STATEMENTS.iter().map(|other| format!("`{}`", other.word));
    words.collect::<Vec<_>>().join(", ")
}

/// Statements, each with parts of suspensions that it may state.
const PARTS: [(&str, &[&str]); 4] = [
    ("hinge", &["arm", "wishbone", "rocker", "revolute"]),
    ("body", &["upright", "knuckle", "carrier", "part"]),
    ("link", &["rod", "bar", "pushrod"]),
    ("measure", &["spring", "damper", "length"]),
];

fn unknown_statement(word: &Ident) -> syn::Error {
    let known = STATEMENTS.iter().map(|other| other.word);
    let mut parts = PARTS.iter();
    let part = parts.find(|(_, parts)| parts.iter().any(|part| word == *part));
    let statement = STATEMENTS
        .iter()
        .find(|other| part.is_some_and(|(statement, _)| other.word == *statement));
    let hint = match statement {
        Some(Word { syntax, .. }) => format!("; a part like this is stated as `{syntax}`"),
        None => did_you_mean(&word.to_string(), known),
    };
    errors::at(
        word,
        format!("unknown statement `{word}`; write one of {}{hint}", words()),
    )
}

/// The parser's expectation, and an example of the statement.
fn with_example(error: syn::Error, Word { word, syntax, .. }: &Word) -> syn::Error {
    let message = error.to_string();
    if let Some(message) = errors::keyword_as_name(&message) {
        return syn::Error::new(error.span(), message);
    }
    if !errors::is_from_parser(&message) {
        return error;
    }
    let article = if word.starts_with(['a', 'e', 'i', 'o', 'u']) {
        "an"
    } else {
        "a"
    };
    syn::Error::new(
        error.span(),
        format!("{message}; {article} `{word}` is written `{syntax}`"),
    )
}

/// Whether a statement that was read from `begin` ends here, at the next one or at the end. If its last word is that of the
/// next one, as behind a comma, it does not.
pub(super) fn is_at_end(begin: Cursor<'_>, input: ParseStream<'_>) -> bool {
    let last = errors::tokens(begin, input.cursor()).last();
    let is_word = |last| matches!(&last, TokenTree::Ident(word) if known(word).is_some());
    (input.is_empty() || first_word(input).is_some()) && !last.is_some_and(is_word)
}

/// How names are written, where the parser stopped at a `-` before a word.
fn with_spelling(error: syn::Error, input: ParseStream<'_>) -> syn::Error {
    if input.peek(Token![-]) && input.peek2(Ident) {
        let message = format!("{error}; a name has `_` where others have `-`");
        return syn::Error::new(error.span(), message);
    }
    error
}

/// Skips past the next semicolon, or to the next known statement if that comes first, and past its comments.
pub(super) fn skip_statement(input: ParseStream<'_>) -> syn::Result<()> {
    let is_known = |word: Ident| known(&word).is_some();
    let is_at_statement = || !input.peek(Token![#]) && first_word(input).is_some_and(is_known);
    while !input.is_empty() && !is_at_statement() {
        let token: TokenTree = input.parse()?;
        if is_punct(&token, ';') {
            break;
        }
    }
    Ok(())
}
