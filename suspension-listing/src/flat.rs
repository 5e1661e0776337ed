//! The statements of a listing as text: includes and mirrors are written out, and each point has a position.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};
use syn::Ident;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};

use crate::include::IncludeSource;
use crate::listing::Named;
use crate::parse::flat_statements;
use crate::statement::marker::POINT;
use crate::statement::operands::docs;
use crate::statement::points::{FIXED, FREE, declared};
use crate::vector::Vector;

/// The positions by the names of points, which have no `r#`.
pub(crate) type At<'a> = &'a dyn Fn(&str) -> Option<Vector>;

/// Prints the statements of a listing.
pub(crate) fn printed(
    input: ParseStream<'_>,
    includes: &dyn IncludeSource,
    at: At<'_>,
) -> syn::Result<String> {
    let statements = flat_statements(input, includes)?;
    let texts = statements.into_iter().map(|tokens| {
        let read = |input: ParseStream<'_>| statement(input, at);
        read.parse2(tokens)
    });
    texts.collect()
}

/// A statement, with its docs, as lines.
fn statement(input: ParseStream<'_>, at: At<'_>) -> syn::Result<String> {
    let docs = docs(input)?;
    let docs = lines(&docs).map(|line| format!("///{line}\n"));
    let docs: String = docs.collect();
    let word: Ident = input.parse()?;
    let rest = if word == FIXED.word || word == FREE.word {
        points(input, &word, at)?
    } else if word == POINT.word {
        marker(input.parse()?, at)
    } else {
        spaced(input.parse()?)
    };
    let before = if rest.starts_with(':') { "" } else { " " };
    Ok(format!("{docs}{word}{before}{rest}\n"))
}

/// The lines of docs, one of which may be a whole block comment.
fn lines(docs: &[String]) -> impl Iterator<Item = &str> {
    docs.iter().flat_map(|docs| docs.lines())
}

/// `: a at [x, y, z], b at [x, y, z];`, one point below the other.
fn points(input: ParseStream<'_>, word: &Ident, at: At<'_>) -> syn::Result<String> {
    const INDENT: &str = "\n       ";
    let points = declared(input, word)?;
    input.parse::<syn::Token![;]>()?;
    let names = || points.iter().map(|point| point.named.name.to_string());
    let width = names().map(|name| name.len()).max().unwrap_or_default();
    let items = points.iter().map(|point| {
        let Named { docs, name } = &point.named;
        let docs = lines(docs).map(|line| format!("///{line}{INDENT}"));
        let docs: String = docs.collect();
        let at = position(name, at);
        let width = if at.is_empty() { 0 } else { width };
        format!("{docs}{:width$}{at}", name.to_string())
    });
    let items: Vec<String> = items.collect();
    let gap = if word == FREE.word { "  " } else { " " };
    Ok(format!(":{gap}{};", items.join(&format!(",{INDENT}"))))
}

/// `hub: plate at [x, y, z];` with another position than in the tokens.
fn marker(tokens: TokenStream, at: At<'_>) -> String {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let is_at = |token: &TokenTree| matches!(token, TokenTree::Ident(at) if at == "at");
    let carried = match tokens.as_slice() {
        [carried @ .., word, TokenTree::Group(_), _] if is_at(word) => carried,
        [carried @ .., _] => carried,
        [] => &[],
    };
    let at = match carried.first() {
        Some(TokenTree::Ident(name)) => position(name, at),
        _ => String::new(),
    };
    format!("{}{at};", spaced(carried.iter().cloned().collect()))
}

/// ` at [x, y, z]`, with the shortest numbers that are read as the same.
fn position(name: &Ident, at: At<'_>) -> String {
    let at = at(&name.unraw().to_string());
    at.map_or_else(String::new, |[x, y, z]| {
        format!(" at [{x:?}, {y:?}, {z:?}]")
    })
}

/// Tokens with the spaces that a person would type.
fn spaced(tokens: TokenStream) -> String {
    let mut text = String::new();
    let mut before: Option<TokenTree> = None;
    let mut is_sign = false;
    for token in tokens {
        if let Some(before) = &before
            && !is_sign
            && !touches(before, &token)
        {
            text.push(' ');
        }
        let follows_none = matches!(before, None | Some(TokenTree::Punct(_)));
        is_sign = follows_none && is_alone(&token, '-');
        text.push_str(&piece(&token));
        before = Some(token);
    }
    text
}

fn piece(token: &TokenTree) -> String {
    let TokenTree::Group(group) = token else {
        return token.to_string();
    };
    let content = spaced(group.stream());
    match group.delimiter() {
        Delimiter::Parenthesis => format!("({content})"),
        Delimiter::Bracket => format!("[{content}]"),
        Delimiter::Brace => format!("{{{content}}}"),
        Delimiter::None => content,
    }
}

/// Whether no space stands between two tokens.
fn touches(before: &TokenTree, token: &TokenTree) -> bool {
    match (before, token) {
        (TokenTree::Punct(before), _) if before.as_char() == '.' => true,
        (TokenTree::Punct(before), _) if before.spacing() == Spacing::Joint => true,
        (_, TokenTree::Punct(punct)) => matches!(punct.as_char(), ',' | ';' | ':' | '.'),
        (TokenTree::Ident(_), TokenTree::Group(group)) => {
            group.delimiter() == Delimiter::Parenthesis
        }
        _ => false,
    }
}

fn is_alone(token: &TokenTree, character: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == character && punct.spacing() == Spacing::Alone)
}
