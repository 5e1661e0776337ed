//! From tokens to the listing. A statement that cannot be read is reported and skipped.

use proc_macro2::{Span, TokenTree};
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Ident, Token};

use crate::errors::{self, Errors};
use crate::listing::Listing;
use crate::statement::STATEMENTS;
use crate::statement::mirror::Mirror;
use crate::statement::operands::{docs, lines};
use crate::statement::word::{Head, Word};

/// Reads the statements of a listing, to the end of the input, and the errors of those that could not be
/// read. Messages about the listing as a whole point to `span`.
///
/// # Errors
///
/// Where what cannot be read cannot be skipped.
pub fn statements(input: ParseStream<'_>, span: Span) -> syn::Result<(Listing, Errors)> {
    let mut listing = Listing::empty(span);
    let mut errors = Errors::default();
    match lines(&input.call(Attribute::parse_inner)?) {
        Ok(lines) => listing.docs = lines,
        Err(error) => errors.push(error),
    }
    let mut texts = Vec::new();
    while !input.is_empty() {
        let ahead = input.fork();
        match statement(input, &mut listing) {
            Ok(()) => texts.push(tokens(&ahead)?),
            Err(error) => {
                errors.push(error);
                listing.incomplete = true;
                skip_statement(input)?;
            }
        }
    }
    if let Some(sides) = listing.mirror.clone()
        && let Err(error) = mirror(&Mirror { sides }, &texts, &mut listing)
    {
        errors.push(error);
    }
    Ok((listing, errors))
}

/// The tokens of the next statement, to its semicolon.
fn tokens(input: ParseStream<'_>) -> syn::Result<Vec<TokenTree>> {
    let mut tokens = Vec::new();
    loop {
        let token: TokenTree = input.parse()?;
        let is_last = matches!(&token, TokenTree::Punct(punct) if punct.as_char() == ';');
        tokens.push(token);
        if is_last {
            return Ok(tokens);
        }
    }
}

/// Adds the other side of the vehicle.
fn mirror(mirror: &Mirror, texts: &[Vec<TokenTree>], listing: &mut Listing) -> syn::Result<()> {
    mirror.points(listing)?;
    for image in texts.iter().filter_map(|text| mirror.statement(text)) {
        let read = |input: ParseStream<'_>| statement(input, listing);
        read.parse2(image)?;
    }
    Ok(())
}

fn statement(input: ParseStream<'_>, listing: &mut Listing) -> syn::Result<()> {
    let docs = docs(input)?;
    let word: Ident = input.parse()?;
    let mut statements = STATEMENTS.iter();
    let Some(statement) = statements.find(|statement| word == statement.word) else {
        return Err(unknown_statement(&word));
    };
    let read = (statement.read)(Head { docs, word }, input, listing);
    read.and_then(|()| input.parse::<Token![;]>().map(drop))
        .map_err(|error| with_example(error, statement))
}

fn unknown_statement(word: &Ident) -> syn::Error {
    let words = STATEMENTS.iter().map(|other| format!("`{}`", other.word));
    let words = words.collect::<Vec<_>>().join(", ");
    errors::at(
        word,
        format!("unknown statement `{word}`; write one of {words}"),
    )
}

/// What the parser expected, and how the statement is written.
fn with_example(error: syn::Error, Word { word, syntax, .. }: &Word) -> syn::Error {
    let message = error.to_string();
    if !is_of_the_parser(&message) {
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

/// Whether a message is the parser's own, which names what it expected.
pub(crate) fn is_of_the_parser(message: &str) -> bool {
    message.starts_with("expected") || message.starts_with("unexpected end")
}

/// Skips to behind the next semicolon.
fn skip_statement(input: ParseStream<'_>) -> syn::Result<()> {
    while !input.is_empty() {
        if let TokenTree::Punct(punct) = input.parse()?
            && punct.as_char() == ';'
        {
            break;
        }
    }
    Ok(())
}
