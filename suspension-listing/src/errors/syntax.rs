//! Of statements that cannot be read.

use proc_macro2::Span;
use syn::spanned::Spanned;
use syn::{Attribute, Error, Ident, Lit};

use super::at;

pub fn not_a_doc_comment(attribute: &Attribute) -> Error {
    Error::new(
        attribute.span(),
        "only doc comments are allowed on statements; remove the attribute",
    )
}

pub fn unknown_statement(keyword: &Ident) -> Error {
    at(
        keyword,
        format!(
            "unknown statement `{keyword}`; write one of `fixed`, `free`, `link`, `body`, `drive`, \
             `measure`, `point`, `wheel`, `kingpin`"
        ),
    )
}

pub fn no_points(keyword: &Ident) -> Error {
    at(
        keyword,
        format!("`{keyword}` lists no points; name one, or remove the statement"),
    )
}

pub fn unknown_quantity(function: &Ident) -> Error {
    at(
        function,
        format!(
            "a drive cannot prescribe `{function}(..)`; write `p.z`, `p.z - q.z` or `angle(p -> q, z)`"
        ),
    )
}

pub fn unknown_measure(function: &Ident) -> Error {
    at(
        function,
        format!(
            "`{function}(..)` cannot be measured; write `p.z`, `p.z - q.z`, `angle(p -> q, z)` or \
             `length(p -> q)`"
        ),
    )
}

pub fn not_a_position(keyword: &Ident) -> Error {
    at(
        keyword,
        format!("unexpected `{keyword}`; write `,`, or a design position: `at [x, y, z]`"),
    )
}

pub fn not_three_coordinates(span: Span, count: usize) -> Error {
    Error::new(
        span,
        format!("a design position has three coordinates, {count} are given; write `[x, y, z]`"),
    )
}

pub fn not_a_number(literal: &Lit) -> Error {
    Error::new(
        literal.span(),
        "a coordinate is a number, for example `-1.25`",
    )
}

pub fn behind_the_listing(span: Span) -> Error {
    Error::new(span, "nothing may follow the listing; remove it")
}
