//! The common syntax of statements: names, brackets, doc comments. What comes next is looked at and not parsed on trial: the first
//! error of `syn` in a thread allocates what the main thread never frees, and a good listing makes none.

use proc_macro2::TokenStream;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::punctuated::Punctuated;
use syn::{Attribute, Expr, ExprLit, Ident, Lit, Meta, Token, token};

use crate::errors;

/// Reads the content of brackets to its end. The rest of a content that cannot be read is consumed too, otherwise the
/// parser would report it instead of all other mistakes.
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
    if input.peek(Token![#]) && !input.peek2(token::Bracket) {
        return Err(input.error(if input.peek2(Token![!]) {
            "`//!` is allowed only above the first statement; begin the line with `//`"
        } else {
            "a comment begins with `//`"
        }));
    }
    lines(&input.call(Attribute::parse_outer)?)
}

/// The first word of the statement that begins here, before a `:` or a name and a `:`; doc comments may come before it.
pub(crate) fn first_word(input: ParseStream<'_>) -> Option<Ident> {
    let ahead = input.fork();
    ahead.call(Attribute::parse_outer).ok()?;
    if !ahead.peek(Ident) {
        return None;
    }
    let word = ahead.parse().ok()?;
    let begins = ahead.peek(Token![:]) || ahead.peek(Ident) && ahead.peek2(Token![:]);
    begins.then_some(word)
}

/// Whether a literal comes next.
pub(crate) fn is_literal(input: ParseStream<'_>) -> bool {
    input.cursor().literal().is_some()
}

/// The lines of doc comments.
pub(crate) fn lines(attributes: &[Attribute]) -> syn::Result<Vec<String>> {
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

/// A name of the listing. `r#name` is the same name if it does not need the `r#`.
pub(crate) fn name(input: ParseStream<'_>) -> syn::Result<Ident> {
    let name: Ident = input.parse().map_err(errors::no_name)?;
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

/// `point on` in a statement that is written like `example`.
pub(crate) fn point_on(input: ParseStream<'_>, example: &str) -> syn::Result<Ident> {
    let point = name(input)?;
    let word: Ident = input
        .parse()
        .map_err(|error: syn::Error| syn::Error::new(error.span(), "expected `on`"))?;
    if word == "on" {
        Ok(point)
    } else {
        let message = format!("unexpected `{word}`; write `{example}`");
        Err(errors::at(&word, message))
    }
}

/// `from -> to`.
pub(crate) fn arrow(input: ParseStream<'_>) -> syn::Result<[Ident; 2]> {
    let from = name(input)?;
    input.parse::<Token![->]>()?;
    Ok([from, name(input)?])
}
