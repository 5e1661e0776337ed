//! Quantities, which drives prescribe and measures read: `p.z`, `p.z - q.z`, `p along [0.1, 1.0, 0.0]`,
//! `angle(p -> q, z)`, `length(p -> q)`.

use syn::parse::{Parse, ParseStream};
use syn::{Error, Ident, Token, parenthesized};

use super::operands::{arrow, in_brackets, name};
use super::points::vector;
use crate::errors;
use crate::form::Term;
use crate::listing::Check;
use crate::name::Name;
use crate::system::{self, AXES, Site};
use crate::vector::{Vector, dot};

pub(super) enum Quantity {
    /// `of.axis` or `of.axis - minus.axis`.
    Coordinate {
        of: Coordinate,
        minus: Option<Coordinate>,
    },
    /// `angle(from -> to, axis)`.
    Angle { line: [Ident; 2], axis: Ident },
    /// `length(from -> to)`.
    Length { line: [Ident; 2] },
    /// `point along [x, y, z]`, with a unit vector.
    Along { point: Ident, direction: Vector },
}

pub(super) struct Coordinate {
    pub(super) point: Ident,
    axis: Ident,
}

impl Quantity {
    pub(super) fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        match function(input)? {
            None if input.peek2(Ident) => along(input),
            None => coordinate(input),
            Some(function) if function == "angle" => operands(input, |content| {
                let line = arrow(content)?;
                content.parse::<Token![,]>()?;
                let axis = content.parse()?;
                Ok(Self::Angle { line, axis })
            }),
            Some(function) if function == "length" => {
                let line = operands(input, arrow)?;
                Ok(Self::Length { line })
            }
            Some(function) => Err(unknown_quantity(&function)),
        }
    }

    pub(super) fn points(&self) -> Vec<&Ident> {
        match self {
            Self::Coordinate { of, minus } => [Some(of), minus.as_ref()]
                .into_iter()
                .flatten()
                .map(|coordinate| &coordinate.point)
                .collect(),
            Self::Angle { line, .. } | Self::Length { line } => line.iter().collect(),
            Self::Along { point, .. } => vec![point],
        }
    }

    /// Checks the axes.
    pub(super) fn check(&self, check: &mut Check<'_>) {
        let axis = match self {
            Self::Coordinate { of, .. } => &of.axis,
            Self::Angle { axis, .. } => axis,
            Self::Length { .. } | Self::Along { .. } => return,
        };
        if !AXES.iter().any(|name| axis == name) {
            check.report(unknown_axis(axis));
        }
        if let Self::Coordinate {
            minus: Some(minus), ..
        } = self
            && minus.axis != *axis
        {
            check.report(different_axes(&minus.axis, axis));
        }
    }

    /// As text, equal for two that are one up to sign.
    pub(super) fn text(&self) -> String {
        let mut points: Vec<String> = self.points().iter().map(ToString::to_string).collect();
        points.sort();
        let axis = match self {
            Self::Coordinate { of, .. } => of.axis.to_string(),
            Self::Angle { axis, .. } => axis.to_string(),
            Self::Length { .. } => String::new(),
            Self::Along { direction, .. } => format!("{direction:?}"),
        };
        format!("{} {axis}", points.join(" "))
    }

    /// The coordinates that add up to what the equation of a drive prescribes.
    pub(super) fn terms(&self, site: impl Fn(&Ident) -> Site) -> Vec<Term> {
        let (axis, plus, minus) = match self {
            Self::Coordinate { of, minus } => {
                let minus = minus.as_ref().map(|minus| &minus.point);
                (&of.axis, &of.point, minus)
            }
            Self::Angle {
                line: [from, to],
                axis,
            } => (axis, to, Some(from)),
            Self::Along { point, direction } => {
                let axes = direction
                    .iter()
                    .enumerate()
                    .filter(|(_, factor)| **factor != 0.0);
                let term = |(axis, factor): (usize, &f64)| Term {
                    factor: *factor,
                    site: site(point),
                    axis,
                };
                return axes.map(term).collect();
            }
            Self::Length { .. } => return Vec::new(),
        };
        let axis = axis_index(axis);
        let term = |(factor, point): (f64, &Ident)| Term {
            factor,
            site: site(point),
            axis,
        };
        let ends = [Some((1.0, plus)), minus.map(|minus| (-1.0, minus))];
        ends.into_iter().flatten().map(term).collect()
    }

    /// The same without places in the source.
    pub(super) fn plain(&self) -> system::Quantity {
        match self {
            Self::Coordinate { of, minus } => system::Quantity::Coordinate {
                axis: axis_index(&of.axis),
                of: Name::from(&of.point),
                minus: minus.as_ref().map(|minus| Name::from(&minus.point)),
            },
            Self::Angle { line, axis } => system::Quantity::Angle {
                axis: axis_index(axis),
                line: line.each_ref().map(Name::from),
            },
            Self::Length { line } => system::Quantity::Length {
                line: line.each_ref().map(Name::from),
            },
            Self::Along { point, direction } => system::Quantity::Along {
                point: Name::from(point),
                direction: *direction,
            },
        }
    }
}

/// `of.axis` or `of.axis - minus.axis`.
fn coordinate(input: ParseStream<'_>) -> syn::Result<Quantity> {
    let of = input.parse()?;
    let minus = match input.parse::<Option<Token![-]>>()? {
        Some(_) => Some(input.parse()?),
        None => None,
    };
    Ok(Quantity::Coordinate { of, minus })
}

/// `point along [x, y, z]`.
fn along(input: ParseStream<'_>) -> syn::Result<Quantity> {
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
            "`[0, 0, 0]` is no direction; write where it points",
        ));
    }
    let scaled = stated.map(|x| x / largest);
    let length = dot(scaled, scaled).sqrt();
    let direction = scaled.map(|x| x / length);
    Ok(Quantity::Along { point, direction })
}

impl Parse for Coordinate {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let point = name(input)?;
        input.parse::<Token![.]>()?;
        let axis = input.parse()?;
        Ok(Self { point, axis })
    }
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
    in_brackets(&content, read)
}

fn axis_index(axis: &Ident) -> usize {
    let mut axes = AXES.iter();
    axes.position(|name| axis == name).unwrap_or_default()
}

fn unknown_quantity(function: &Ident) -> Error {
    errors::at(
        function,
        format!(
            "there is no quantity `{function}(..)`; write `p.z`, `p.z - q.z`, `p along [0, 1, 0]`, \
             `angle(p -> q, z)` or `length(p -> q)`"
        ),
    )
}

fn not_along(word: &Ident) -> Error {
    errors::at(
        word,
        format!("unexpected `{word}`; write `;`, or a direction: `along [x, y, z]`"),
    )
}

fn unknown_axis(axis: &Ident) -> Error {
    errors::at(
        axis,
        format!("there is no axis `{axis}`; write `x`, `y` or `z`"),
    )
}

fn different_axes(axis: &Ident, expected: &Ident) -> Error {
    errors::at(
        axis,
        format!("both coordinates must be along one axis; write `.{expected}`"),
    )
}
