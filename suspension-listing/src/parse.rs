//! From tokens to the listing, and what statements have in common. A statement that cannot be read is
//! reported and skipped.

use proc_macro2::{Span, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::punctuated::Punctuated;
use syn::{Attribute, Expr, ExprLit, Ident, Lit, Meta, Token};

use crate::errors::{self, Errors};
use crate::listing::Listing;
use crate::statement::{Head, STATEMENTS, Word};

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
    while !input.is_empty() {
        if let Err(error) = statement(input, &mut listing) {
            errors.push(error);
            listing.incomplete = true;
            skip_statement(input)?;
        }
    }
    Ok((listing, errors))
}

fn statement(input: ParseStream<'_>, listing: &mut Listing) -> syn::Result<()> {
    let docs = docs(input)?;
    let word: Ident = input.parse()?;
    let mut statements = STATEMENTS.iter();
    let Some(statement) = statements.find(|statement| word == statement.word) else {
        return Err(errors::unknown_statement(&word));
    };
    let read = (statement.read)(Head { docs, word }, input, listing);
    read.and_then(|()| input.parse::<Token![;]>().map(drop))
        .map_err(|error| with_example(error, statement))
}

/// What the parser expected, and how the statement is written.
fn with_example(error: syn::Error, Word { word, syntax, .. }: &Word) -> syn::Error {
    let message = error.to_string();
    if !is_of_the_parser(&message) {
        return error;
    }
    syn::Error::new(
        error.span(),
        format!("{message}; a `{word}` is written `{syntax}`"),
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

/// Reads what stands in brackets, to its end. What is left of what cannot be read is taken too: the parser
/// would report it in place of all other mistakes.
pub(crate) fn in_brackets<T>(
    content: ParseStream<'_>,
    read: impl FnOnce(ParseStream<'_>) -> syn::Result<T>,
) -> syn::Result<T> {
    let read = read(content).and_then(|read| {
        if content.is_empty() {
            Ok(read)
        } else {
            Err(content.error("nothing may follow in these brackets; remove it"))
        }
    });
    content.parse::<TokenStream>()?;
    read
}

/// The lines of the doc comments that come next.
pub(crate) fn docs(input: ParseStream<'_>) -> syn::Result<Vec<String>> {
    lines(&input.call(Attribute::parse_outer)?)
}

fn lines(attributes: &[Attribute]) -> syn::Result<Vec<String>> {
    let line = |attribute: &Attribute| match &attribute.meta {
        Meta::NameValue(meta) if meta.path.is_ident("doc") => match &meta.value {
            Expr::Lit(ExprLit {
                lit: Lit::Str(line),
                ..
            }) => Ok(line.value()),
            _ => Err(errors::not_a_doc_comment(attribute)),
        },
        _ => Err(errors::not_a_doc_comment(attribute)),
    };
    attributes.iter().map(line).collect()
}

/// A name of the listing. `r#name` is the same name where it needs no `r#`.
pub(crate) fn name(input: ParseStream<'_>) -> syn::Result<Ident> {
    let name: Ident = input.parse()?;
    let plain = syn::parse_str::<Ident>(&name.unraw().to_string());
    Ok(plain.map_or(name.clone(), |plain| {
        Ident::new(&plain.to_string(), name.span())
    }))
}

/// `a, b, c`.
pub(crate) fn names(input: ParseStream<'_>) -> syn::Result<Vec<Ident>> {
    let names = Punctuated::<Ident, Token![,]>::parse_separated_nonempty_with(input, name)?;
    Ok(names.into_iter().collect())
}

/// `from -> to`.
pub(crate) fn arrow(input: ParseStream<'_>) -> syn::Result<[Ident; 2]> {
    let from = name(input)?;
    input.parse::<Token![->]>()?;
    Ok([from, name(input)?])
}
