//! The syntax of a quantity.

use syn::parse::ParseStream;
use syn::{Error, Ident, Token, parenthesized};

use super::Quantity;
use crate::did_you_mean::did_you_mean;
use crate::errors;
use crate::statement::operands::{arrow, in_brackets, name};
use crate::statement::points::vector;
use crate::vector::dot;

pub(super) fn quantity(input: ParseStream<'_>) -> syn::Result<Quantity> {
    match function(input)? {
        None if input.peek(Ident) && input.peek2(Ident) => parse_along(input),
        None if input.peek(Ident) && input.peek2(Token![->]) => Err(bare_line(&arrow(input)?)),
        None => Ok(Quantity::Sum(input.parse()?)),
        Some(function) if function == "angle" => operands(input, angle),
        Some(function) if function == "length" => {
            let line = operands(input, arrow)?;
            Ok(Quantity::Length { line })
        }
        Some(function) => Err(unknown_quantity(&function)),
    }
}

/// `from -> to, axis`, or two lines, with or without the line about which their angle is seen.
fn angle(content: ParseStream<'_>) -> syn::Result<Quantity> {
    let line = arrow(content)?;
    content.parse::<Token![,]>()?;
    if !content.peek2(Token![->]) {
        let axis = content.parse()?;
        if content.peek(Ident) {
            let word: Ident = content.parse()?;
            return Err(if word == "about" {
                axis_about(&word)
            } else {
                not_about(&word)
            });
        }
        return Ok(Quantity::Angle { line, axis });
    }
    let lines = [line, arrow(content)?];
    let about = if content.peek(Ident) {
        let word: Ident = content.parse()?;
        if word != "about" {
            return Err(not_about(&word));
        }
        Some(arrow(content)?)
    } else {
        None
    };
    Ok(Quantity::Between { lines, about })
}

/// `point along [x, y, z]`.
fn parse_along(input: ParseStream<'_>) -> syn::Result<Quantity> {
    let (point, word) = (name(input)?, input.parse::<Ident>()?);
    if word != "along" {
        return Err(not_along(&word));
    }
    let span = input.span();
    let stated = vector(input, "a direction")?;
    let largest = stated
        .iter()
        .fold(0.0_f64, |largest, x| largest.max(x.abs()));
    if largest == 0.0 {
        return Err(Error::new(
            span,
            "`[0, 0, 0]` is not a direction; write a vector other than zero",
        ));
    }
    let scaled = stated.map(|x| x / largest);
    let length = dot(scaled, scaled).sqrt();
    let direction = scaled.map(|x| x / length);
    Ok(Quantity::Along { point, direction })
}

/// The word before a parenthesis.
fn function(input: ParseStream<'_>) -> syn::Result<Option<Ident>> {
    let is_call = input.peek(syn::token::Paren) || input.peek2(syn::token::Paren);
    is_call.then(|| input.parse()).transpose()
}

/// The content of parentheses, to its end.
fn operands<T>(
    input: ParseStream<'_>,
    read: impl FnOnce(ParseStream<'_>) -> syn::Result<T>,
) -> syn::Result<T> {
    let content;
    parenthesized!(content in input);
    in_brackets(&content, read)
}

fn unknown_quantity(function: &Ident) -> Error {
    let hint = did_you_mean(&function.to_string(), ["angle", "length"]);
    errors::at(
        function,
        format!(
            "there is no quantity `{function}(..)`; write `p.z`, `0.5 p.z + 0.5 q.z`, `p along [0, 1, 0]`, \
             `angle(p -> q, z)`, `angle(p -> q, r -> s)`, `angle(p -> q, r -> s about t -> u)` or `length(p -> q)`{hint}"
        ),
    )
}

/// The error for a line without a word that says what is measured.
fn bare_line([from, to]: &[Ident; 2]) -> Error {
    errors::at(
        from,
        format!(
            "`{from} -> {to}` is a line; write `length({from} -> {to})` for its length, `angle({from} -> {to}, z)` for its angle \
             about an axis"
        ),
    )
}

fn not_about(word: &Ident) -> Error {
    errors::at(
        word,
        format!(
            "unexpected `{word}`; write `)`, or the line that the angle is about: `about t -> u`"
        ),
    )
}

fn axis_about(word: &Ident) -> Error {
    errors::at(
        word,
        "an angle about a line must be between two lines; in place of the axis write a line, for example through two chassis points: \
         `angle(p -> q, r -> s about t -> u)`",
    )
}

fn not_along(word: &Ident) -> Error {
    errors::at(
        word,
        format!("unexpected `{word}`; write `;`, or a direction: `along [x, y, z]`"),
    )
}
