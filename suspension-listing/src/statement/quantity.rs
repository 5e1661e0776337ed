//! Quantities, which drives prescribe and measures read: sums of coordinates, `p along [0.1, 1.0, 0.0]`,
//! `angle(p -> q, z)`, `angle(p -> q, r -> s)`, `length(p -> q)`.

use syn::parse::ParseStream;
use syn::{Error, Ident, Token, parenthesized};

use super::operands::{arrow, in_brackets, name};
use super::points::vector;
use super::sum::{Sum, Term, axis_index};
use crate::did_you_mean::did_you_mean;
use crate::errors;
use crate::form;
use crate::listing::Check;
use crate::name::Name;
use crate::system::{self, Site};
use crate::vector::{Vector, dot};

pub(super) enum Quantity {
    /// `p.z`, `p.z - q.z`, `0.5 p.z + 0.5 q.z`.
    Sum(Sum),
    /// `angle(from -> to, axis)`.
    Angle { line: [Ident; 2], axis: Ident },
    /// `angle(p -> q, r -> s)`, or the same `about t -> u`.
    Between {
        lines: [[Ident; 2]; 2],
        about: Option<[Ident; 2]>,
    },
    /// `length(from -> to)`.
    Length { line: [Ident; 2] },
    /// `point along [x, y, z]`, with a unit vector.
    Along { point: Ident, direction: Vector },
}

impl Quantity {
    pub(super) fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        match function(input)? {
            None if input.peek(Ident) && input.peek2(Ident) => along(input),
            None if input.peek(Ident) && input.peek2(Token![->]) => Err(bare_line(&arrow(input)?)),
            None => Ok(Self::Sum(input.parse()?)),
            Some(function) if function == "angle" => operands(input, angle),
            Some(function) if function == "length" => {
                let line = operands(input, arrow)?;
                Ok(Self::Length { line })
            }
            Some(function) => Err(unknown_quantity(&function)),
        }
    }

    pub(super) fn points(&self) -> Vec<&Ident> {
        match self {
            Self::Sum(sum) => sum.points(),
            Self::Angle { line, .. } | Self::Length { line } => line.iter().collect(),
            Self::Between { lines, about } => {
                let lines = lines.iter().chain(about).flatten();
                let mut points: Vec<&Ident> = lines.collect();
                points.sort();
                points.dedup();
                points
            }
            Self::Along { point, .. } => vec![point],
        }
    }

    /// Checks the axes.
    pub(super) fn check(&self, check: &mut Check<'_>) {
        match self {
            Self::Sum(sum) => sum.check(check),
            Self::Angle { axis, .. } => check.axis(axis),
            Self::Between { lines, about } => {
                for [from, to] in lines.iter().chain(about) {
                    if from == to {
                        check.report(errors::same_point_twice(to));
                    }
                }
                let axis = about.as_ref().map(undirected);
                let along = lines.iter().find(|line| Some(undirected(line)) == axis);
                if let Some([from, to]) = along {
                    check.report(errors::along_axis(from, to));
                }
            }
            Self::Length { .. } | Self::Along { .. } => {}
        }
    }

    /// As text, equal for two that are one up to sign and a constant.
    pub(super) fn text(&self) -> String {
        match self {
            Self::Sum(sum) => format!("sum {}", sum.text()),
            Self::Angle { line, axis } => format!("angle {:?} {axis}", undirected(line)),
            Self::Between { lines, about } => {
                let mut lines = lines.each_ref().map(undirected);
                lines.sort();
                format!("between {lines:?} {:?}", about.as_ref().map(undirected))
            }
            Self::Length { line } => format!("length {:?}", undirected(line)),
            Self::Along { point, direction } => {
                let first = direction.iter().find(|factor| **factor != 0.0);
                let sign = first.map_or(1.0, |factor| factor.signum());
                // The zero is for -0.
                let direction = direction.map(|factor| sign * factor + 0.0);
                format!("along {direction:?} {point}")
            }
        }
    }

    /// The coordinates that add up to what the equation of a drive prescribes.
    pub(super) fn terms(&self, site: impl Fn(&Ident) -> Site) -> Vec<form::Term> {
        match self {
            Self::Sum(sum) => sum.terms(site),
            Self::Angle {
                line: [from, to],
                axis,
            } => {
                let axis = axis_index(axis);
                let term = |(factor, point)| form::Term {
                    factor,
                    site: site(point),
                    axis,
                };
                [(1.0, to), (-1.0, from)].map(term).to_vec()
            }
            Self::Along { point, direction } => {
                let axes = direction
                    .iter()
                    .enumerate()
                    .filter(|(_, factor)| **factor != 0.0);
                let term = |(axis, factor): (usize, &f64)| form::Term {
                    factor: *factor,
                    site: site(point),
                    axis,
                };
                axes.map(term).collect()
            }
            Self::Length { .. } | Self::Between { .. } => Vec::new(),
        }
    }

    /// The same without places in the source.
    pub(super) fn plain(&self) -> system::Quantity {
        match self {
            Self::Sum(sum) => {
                let term = |term: &Term| system::Term {
                    factor: term.factor,
                    point: Name::from(&term.point),
                    axis: term.axis(),
                };
                system::Quantity::Sum(sum.terms.iter().map(term).collect())
            }
            Self::Angle { line, axis } => system::Quantity::Angle {
                axis: axis_index(axis),
                line: line.each_ref().map(Name::from),
            },
            Self::Between { lines, about } => system::Quantity::Between {
                lines: lines.each_ref().map(|line| line.each_ref().map(Name::from)),
                about: about.as_ref().map(|line| line.each_ref().map(Name::from)),
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

/// The names of a line's ends, in one order for both directions.
fn undirected(line: &[Ident; 2]) -> [String; 2] {
    let mut ends = line.each_ref().map(ToString::to_string);
    ends.sort();
    ends
}

/// `from -> to, axis`, or two lines, with or without the one about which their angle is seen.
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

/// For a line of which it is not said what of it is meant.
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
        "an angle about a line is one between two lines; in place of the axis write a line, of two chassis points say: \
         `angle(p -> q, r -> s about t -> u)`",
    )
}

fn not_along(word: &Ident) -> Error {
    errors::at(
        word,
        format!("unexpected `{word}`; write `;`, or a direction: `along [x, y, z]`"),
    )
}
