//! A text as tokens, within the limits of size.

use proc_macro2::{Group, LexError, Literal, Span, TokenStream, TokenTree, fallback};
use syn::Error;

use crate::mistake::Mistake;

/// The largest length of a text, in bytes.
pub const MOST_BYTES: usize = 65_536;

/// The largest depth of nested brackets; statements need one.
pub const DEEPEST: usize = 8;

/// The largest length of a number, in characters.
pub const LONGEST_NUMBER: usize = 100;

/// Whether the lexer tells places in a text, which the compiler's own lexer does not.
fn has_places() -> bool {
    let tokens = "a b".parse::<TokenStream>();
    let second = tokens.ok().and_then(|tokens| tokens.into_iter().nth(1));
    second.is_some_and(|second| second.span().start().column == 2)
}

/// Does work with the lexer that tells places in a text.
pub(crate) fn with_lexer_places<T>(work: impl FnOnce() -> T) -> T {
    if has_places() {
        return work();
    }
    fallback::force();
    let done = work();
    fallback::unforce();
    done
}

/// The tokens of a text.
pub(crate) fn tokens(text: &str) -> Result<TokenStream, Vec<Mistake>> {
    if let Some(mistake) = lone_carriage_return(text) {
        return Err(vec![mistake]);
    }
    let tokens: TokenStream = text.parse().map_err(|e| vec![unreadable(text, &e)])?;
    match exceeded(&tokens) {
        Some(error) => Err(vec![Mistake::new(text, &error)]),
        None => Ok(tokens),
    }
}

/// Refuses a line that ends in a carriage return alone: a comment continues after it, although an editor shows a new
/// line.
fn lone_carriage_return(text: &str) -> Option<Mistake> {
    let mut lines = text.split('\n').enumerate();
    lines.find_map(|(number, line)| {
        let line = line.strip_suffix('\r').unwrap_or(line);
        let (before, _) = line.split_once('\r')?;
        Some(Mistake {
            message: "a line ends with a carriage return alone; end each line with a line feed, with or without a carriage return before it"
                .to_owned(),
            line: number + 1,
            column: before.chars().count() + 1,
            length: 1,
        })
    })
}

/// Tokens that were read with their places; if the lexer tells no places, all are put at `place`.
pub(crate) fn handed_on(tokens: TokenStream, place: Span) -> TokenStream {
    if has_places() {
        return tokens;
    }
    placed(tokens.to_string().parse().unwrap_or_default(), place)
}

/// The same tokens, all at one place.
pub(crate) fn placed(tokens: TokenStream, place: Span) -> TokenStream {
    let placed = |mut token: TokenTree| {
        if let TokenTree::Group(group) = &token {
            let content = placed(group.stream(), place);
            token = Group::new(group.delimiter(), content).into();
        }
        token.set_span(place);
        token
    };
    tokens.into_iter().map(placed).collect()
}

/// Whether a token is this punctuation mark.
pub(crate) fn is_punct(token: &TokenTree, mark: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == mark)
}

/// Refuses brackets so deep that the parser, which recurses into them, might not return, and numbers that take it
/// long to read.
fn exceeded(tokens: &TokenStream) -> Option<Error> {
    let mut open = vec![(tokens.clone().into_iter(), 0)];
    while let Some((tokens, depth)) = open.last_mut() {
        let depth = *depth;
        match tokens.next() {
            None => {
                open.pop();
            }
            Some(TokenTree::Group(group)) if depth < DEEPEST => {
                open.push((group.stream().into_iter(), depth + 1));
            }
            Some(TokenTree::Group(group)) => {
                let message = format!("brackets are nested more than {DEEPEST} deep");
                return Some(Error::new(group.span_open(), message));
            }
            Some(TokenTree::Literal(literal)) if is_long_number(&literal) => {
                let message = format!("a number has more than {LONGEST_NUMBER} characters");
                return Some(Error::new(literal.span(), message));
            }
            Some(_) => {}
        }
    }
    None
}

fn is_long_number(literal: &Literal) -> bool {
    let text = literal.to_string();
    text.len() > LONGEST_NUMBER && text.starts_with(|first: char| first.is_ascii_digit())
}

fn unreadable(text: &str, error: &LexError) -> Mistake {
    let start = error.span().start();
    let line = text.lines().nth(start.line.saturating_sub(1));
    let rest = line.map_or("", |line| {
        let start = line.char_indices().nth(start.column);
        start.map_or("", |(byte, _)| &line[byte..])
    });
    let message = match rest.chars().next() {
        Some('/') if rest.starts_with("/*") => "`/*` is not closed; close it with `*/`".to_owned(),
        Some('"') => "`\"` is not closed; close it".to_owned(),
        Some(bracket @ ('(' | '[' | '{')) => format!("`{bracket}` is not closed; close it"),
        Some(bracket @ (')' | ']' | '}')) => {
            format!("`{bracket}` has no opening bracket; remove it")
        }
        Some(control) if control.is_control() => {
            format!("the character {control:?} is not allowed; remove it")
        }
        Some(other) if other.is_ascii() => format!("unexpected `{other}`; remove it"),
        Some(other) => {
            let code = u32::from(other);
            let remedy = meant(other).map_or("remove it".to_owned(), |it| format!("write `{it}`"));
            format!("unexpected `{other}` (U+{code:04X}); {remedy}")
        }
        None => "the text ends too early".to_owned(),
    };
    Mistake {
        message,
        line: start.line.max(1),
        column: start.column + 1,
        length: usize::from(!rest.is_empty()),
    }
}

/// The characters of a listing in whose place a word processor writes this one.
fn meant(character: char) -> Option<&'static str> {
    match character {
        '\u{2010}'..='\u{2015}' | '\u{2212}' | '\u{ff0d}' => Some("-"),
        '\u{2192}' | '\u{21d2}' | '\u{27f6}' => Some("->"),
        '\u{201c}'..='\u{201f}' => Some("\""),
        '\u{ff0c}' => Some(","),
        '\u{ff1a}' => Some(":"),
        '\u{ff1b}' => Some(";"),
        _ => None,
    }
}
