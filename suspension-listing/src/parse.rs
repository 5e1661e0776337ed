//! From tokens to the listing. A statement that cannot be read is reported and skipped.

use proc_macro2::{Span, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Attribute, Expr, ExprLit, Ident, Lit, Meta, Token, bracketed, parenthesized};

use crate::ast::{
    Axis, Body, Constraint, Coordinate, Drive, Link, Listing, Marker, Measure, Measured, Named,
    Point, Quantity,
};
use crate::errors::{self, Errors};
use crate::vector::Vector;

/// Reads the statements of a listing, to the end of the input, and the errors of those that could not be
/// read. Messages about the listing as a whole point to `span`.
///
/// # Errors
///
/// What stands behind a statement that cannot be read, and cannot be skipped.
pub fn statements(input: ParseStream<'_>, span: Span) -> syn::Result<(Listing, Errors)> {
    let mut errors = Errors::default();
    let docs = docs(&input.call(Attribute::parse_inner)?).unwrap_or_else(|error| {
        errors.push(error);
        Vec::new()
    });
    let mut listing = Listing {
        docs,
        span,
        free_span: span,
        fixed: Vec::new(),
        free: Vec::new(),
        constraints: Vec::new(),
        drives: Vec::new(),
        measures: Vec::new(),
        markers: Vec::new(),
        wheel: Vec::new(),
        kingpin: Vec::new(),
        incomplete: false,
    };
    while !input.is_empty() {
        if let Err(error) = statement(input, &mut listing) {
            errors.push(error);
            listing.incomplete = true;
            skip_statement(input)?;
        }
    }
    Ok((listing, errors))
}

/// The lines of doc comments.
fn docs(attributes: &[Attribute]) -> syn::Result<Vec<String>> {
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
fn name(input: ParseStream<'_>) -> syn::Result<Ident> {
    let name: Ident = input.parse()?;
    let plain = syn::parse_str::<Ident>(&name.unraw().to_string());
    Ok(plain.map_or(name.clone(), |plain| {
        Ident::new(&plain.to_string(), name.span())
    }))
}

fn statement(input: ParseStream<'_>, listing: &mut Listing) -> syn::Result<()> {
    let docs = docs(&input.call(Attribute::parse_outer)?)?;
    let keyword: Ident = input.parse()?;
    match keyword.to_string().as_str() {
        "fixed" => {
            let points = points(input, &keyword)?;
            listing.fixed.extend(points);
        }
        "free" => {
            listing.free_span = keyword.span();
            let points = points(input, &keyword)?;
            listing.free.extend(points);
        }
        "link" => {
            let named = named(input, docs)?;
            let (from, to) = arrow(input)?;
            listing
                .constraints
                .push(Constraint::Link(Link { named, from, to }));
        }
        "body" => {
            let (named, points) = (named(input, docs)?, names(input)?);
            listing
                .constraints
                .push(Constraint::Body(Body { named, points }));
        }
        "drive" => {
            let (named, quantity) = (named(input, docs)?, input.parse()?);
            listing.drives.push(Drive { named, quantity });
        }
        "measure" => {
            let (named, measured) = (named(input, docs)?, input.parse()?);
            listing.measures.push(Measure { named, measured });
        }
        "point" => {
            let (named, carriers) = (named(input, docs)?, names(input)?);
            listing.markers.push(Marker { named, carriers });
        }
        "wheel" => listing.wheel.push(axis(input, keyword)?),
        "kingpin" => listing.kingpin.push(axis(input, keyword)?),
        _ => return Err(errors::unknown_statement(&keyword)),
    }
    input.parse::<Token![;]>().map(drop)
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

/// `name:` behind a keyword.
fn named(input: ParseStream<'_>, docs: Vec<String>) -> syn::Result<Named> {
    let name = name(input)?;
    input.parse::<Token![:]>()?;
    Ok(Named { docs, name })
}

/// `: a, b at [x, y, z], c`, each with its own docs.
fn points(input: ParseStream<'_>, keyword: &Ident) -> syn::Result<Vec<Point>> {
    input.parse::<Token![:]>()?;
    let mut points = Vec::new();
    while !input.peek(Token![;]) {
        let docs = docs(&input.call(Attribute::parse_outer)?)?;
        let name = name(input)?;
        let at = input.peek(Ident).then(|| position(input)).transpose()?;
        let named = Named { docs, name };
        points.push(Point { named, at });
        if !input.peek(Token![;]) {
            input.parse::<Token![,]>()?;
        }
    }
    if points.is_empty() {
        return Err(errors::no_points(keyword));
    }
    Ok(points)
}

/// `at [x, y, z]`.
fn position(input: ParseStream<'_>) -> syn::Result<Vector> {
    let keyword: Ident = input.parse()?;
    if keyword != "at" {
        return Err(errors::not_a_position(&keyword));
    }
    let content;
    let bracket = bracketed!(content in input);
    let numbers = Punctuated::<Number, Token![,]>::parse_terminated(&content)?;
    let numbers: Vec<f64> = numbers.into_iter().map(|Number(value)| value).collect();
    Vector::try_from(numbers)
        .map_err(|numbers| errors::not_three_coordinates(bracket.span.join(), numbers.len()))
}

/// A number with or without sign.
struct Number(f64);

impl Parse for Number {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let sign = if input.parse::<Option<Token![-]>>()?.is_some() {
            -1.0
        } else {
            1.0
        };
        let number: Lit = input.parse()?;
        let value = match &number {
            Lit::Int(digits) => digits.base10_parse::<f64>(),
            Lit::Float(digits) => digits.base10_parse::<f64>(),
            other => Err(errors::not_a_number(other)),
        };
        Ok(Self(sign * value?))
    }
}

fn names(input: ParseStream<'_>) -> syn::Result<Vec<Ident>> {
    let names = Punctuated::<Ident, Token![,]>::parse_separated_nonempty_with(input, name)?;
    Ok(names.into_iter().collect())
}

fn arrow(input: ParseStream<'_>) -> syn::Result<(Ident, Ident)> {
    let from = name(input)?;
    input.parse::<Token![->]>()?;
    Ok((from, name(input)?))
}

fn axis(input: ParseStream<'_>, keyword: Ident) -> syn::Result<Axis> {
    input.parse::<Token![:]>()?;
    let (from, to) = arrow(input)?;
    Ok(Axis { keyword, from, to })
}

/// The word before a parenthesis.
fn function(input: ParseStream<'_>) -> syn::Result<Option<Ident>> {
    let is_call = input.peek(syn::token::Paren) || input.peek2(syn::token::Paren);
    is_call.then(|| input.parse()).transpose()
}

/// What stands in parentheses, to its end.
fn operands<T>(
    input: ParseStream<'_>,
    read: impl FnOnce(ParseStream<'_>) -> syn::Result<T>,
) -> syn::Result<T> {
    let content;
    parenthesized!(content in input);
    let operands = read(&content)?;
    if content.is_empty() {
        Ok(operands)
    } else {
        Err(content.error("expected `)`"))
    }
}

impl Quantity {
    /// `(from -> to, axis)`.
    fn angle(input: ParseStream<'_>) -> syn::Result<Self> {
        operands(input, |content| {
            let (from, to) = arrow(content)?;
            content.parse::<Token![,]>()?;
            let axis = content.parse()?;
            Ok(Self::Angle { from, to, axis })
        })
    }

    /// `of.axis` or `of.axis - minus.axis`.
    fn coordinate(input: ParseStream<'_>) -> syn::Result<Self> {
        let of = input.parse()?;
        let minus = match input.parse::<Option<Token![-]>>()? {
            Some(_) => Some(input.parse()?),
            None => None,
        };
        Ok(Self::Coordinate { of, minus })
    }
}

impl Parse for Quantity {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        match function(input)? {
            None => Self::coordinate(input),
            Some(function) if function == "angle" => Self::angle(input),
            Some(function) => Err(errors::unknown_quantity(&function)),
        }
    }
}

impl Parse for Measured {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        match function(input)? {
            None => Quantity::coordinate(input).map(Self::Quantity),
            Some(function) if function == "angle" => Quantity::angle(input).map(Self::Quantity),
            Some(function) if function == "length" => {
                let (from, to) = operands(input, arrow)?;
                Ok(Self::Length { from, to })
            }
            Some(function) => Err(errors::unknown_measure(&function)),
        }
    }
}

impl Parse for Coordinate {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let point = name(input)?;
        input.parse::<Token![.]>()?;
        Ok(Self {
            point,
            axis: input.parse()?,
        })
    }
}
