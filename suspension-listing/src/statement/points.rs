//! `fixed: a, b at [0.1, 0.4, 0.2];` and `free: c, d;`: points of the chassis, and points to solve
//! for, with or without a design position.

use proc_macro2::Span;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Error, Ident, Lit, Token, bracketed};

use super::operands::{docs, first_word, in_brackets, name};
use super::word::Word;
use crate::errors;
use crate::listing::{Named, Point};
use crate::vector::Vector;

pub(crate) const FIXED: Word = Word {
    word: "fixed",
    syntax: "fixed: a, b at [0.1, 0.4, 0.2];",
    read: |head, input, listing| {
        listing.fixed.extend(declared(input, &head.word)?);
        Ok(())
    },
};

pub(crate) const FREE: Word = Word {
    word: "free",
    syntax: "free: c, d at [0.1, 0.7, 0.2];",
    read: |head, input, listing| {
        listing.free_span = head.word.span();
        listing.free.extend(declared(input, &head.word)?);
        Ok(())
    },
};

/// `: a, b at [x, y, z], c`, each with its own docs.
pub(crate) fn declared(input: ParseStream<'_>, word: &Ident) -> syn::Result<Vec<Point>> {
    input.parse::<Token![:]>()?;
    let mut points = Vec::new();
    while !input.peek(Token![;]) {
        let (docs, name) = (docs(input)?, name(input)?);
        let at = position(input)?;
        let named = Named { docs, name };
        points.push(Point { named, at });
        if first_word(input).is_some() {
            break;
        }
        let next = input.lookahead1();
        if next.peek(Token![,]) {
            input.parse::<Token![,]>()?;
        } else if !next.peek(Token![;]) {
            return Err(next.error());
        }
    }
    if points.is_empty() {
        return Err(no_points(word));
    }
    Ok(points)
}

/// `at [x, y, z]`, or nothing.
pub(super) fn position(input: ParseStream<'_>) -> syn::Result<Option<Vector>> {
    if !input.peek(Ident) || first_word(input).is_some() {
        return Ok(None);
    }
    let word: Ident = input.parse()?;
    if word != "at" {
        return Err(not_a_position(&word));
    }
    vector(input, "a design position").map(Some)
}

/// `[x, y, z]`.
pub(super) fn vector(input: ParseStream<'_>, what: &str) -> syn::Result<Vector> {
    let content;
    let bracket = bracketed!(content in input);
    let numbers = in_brackets(&content, Punctuated::<Number, Token![,]>::parse_terminated)?;
    let numbers: Vec<f64> = numbers.into_iter().map(|Number(value)| value).collect();
    Vector::try_from(numbers)
        .map_err(|numbers| not_three_coordinates(bracket.span.join(), what, &numbers))
}

/// A number without sign.
pub(super) fn number(input: ParseStream<'_>) -> syn::Result<f64> {
    let place = input.span();
    // `syn` reads the sign as part of a literal: `--0.5` would be 0.5.
    if input.peek(Token![-]) {
        return Err(not_a_number(place));
    }
    let number: Lit = input.parse().map_err(|_| not_a_number(place))?;
    let (digits, unit, value): (_, _, f64) = match &number {
        // `0x10`, `0o17`, `0b1`.
        Lit::Int(whole) if has_prefix(&whole.to_string()) => return Err(not_a_number(place)),
        Lit::Int(whole) => (whole.base10_digits(), whole.suffix(), whole.base10_parse()?),
        Lit::Float(float) => (float.base10_digits(), float.suffix(), float.base10_parse()?),
        _ => return Err(not_a_number(place)),
    };
    if !unit.is_empty() {
        return Err(has_a_unit(place, digits, unit));
    }
    if value.is_finite() {
        Ok(value)
    } else {
        Err(not_a_number(place))
    }
}

/// Whether a whole number is written in another base than ten.
fn has_prefix(number: &str) -> bool {
    ["0x", "0o", "0b"]
        .iter()
        .any(|base| number.starts_with(base))
}

/// A number with or without sign.
struct Number(f64);

impl Parse for Number {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let is_negative = input.parse::<Option<Token![-]>>()?.is_some();
        let place = input.span();
        let number = number(input)?;
        if input.peek(Ident) {
            let unit: Ident = input.parse()?;
            return Err(has_a_unit(place, &number.to_string(), &format!(" {unit}")));
        }
        // The image of a zero must not be a negative zero.
        Ok(Self(if is_negative { 0.0 - number } else { number }))
    }
}

fn no_points(word: &Ident) -> Error {
    errors::at(
        word,
        format!("`{word}` lists no points; name one, or remove the statement"),
    )
}

fn not_a_position(word: &Ident) -> Error {
    errors::at(
        word,
        format!("unexpected `{word}`; write `,` or `;`, or a design position: `at [x, y, z]`"),
    )
}

fn not_three_coordinates(span: Span, what: &str, numbers: &[f64]) -> Error {
    let count = numbers.len();
    let is_whole = |number: &f64| number.fract() == 0.0;
    let is_split = count > 3 && numbers.windows(2).any(|pair| pair.iter().all(is_whole));
    let comma = if is_split {
        "; a decimal separator is a point, as in 0.5"
    } else {
        ""
    };
    Error::new(
        span,
        format!("{what} has three coordinates, {count} are given; write `[x, y, z]`{comma}"),
    )
}

/// The error for `700 mm`, and for `700mm`, which Rust reads as the number 700 with a suffix.
fn has_a_unit(place: Span, digits: &str, unit: &str) -> Error {
    Error::new(
        place,
        format!(
            "a number may not have a unit; write `{digits}` in place of `{digits}{unit}`: all lengths of a listing are in one unit"
        ),
    )
}

fn not_a_number(place: Span) -> Error {
    Error::new(
        place,
        "a coordinate or a factor must be a finite decimal number that begins with a digit or `-`, for example `0.5` or `-1.25`",
    )
}
