//! Sums of coordinates: `p.z`, `p.z - q.z`, `0.5 p.z + 0.5 q.z`.

use syn::parse::{Parse, ParseStream};
use syn::{Error, Ident, Token};

use super::operands::{is_literal, name};
use super::points::number;
use crate::errors;
use crate::form;
use crate::listing::Check;
use crate::system::{AXES, Site};

pub(super) struct Sum {
    pub(super) terms: Vec<Term>,
}

/// A coordinate of a point, times a factor.
pub(super) struct Term {
    pub(super) factor: f64,
    pub(super) point: Ident,
    pub(super) axis: Ident,
}

impl Parse for Sum {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let mut terms = Vec::new();
        let mut sign = match input.parse::<Option<Token![-]>>()? {
            Some(_) => -1.0,
            None => 1.0,
        };
        loop {
            terms.push(term(sign, input)?);
            sign = if input.parse::<Option<Token![+]>>()?.is_some() {
                1.0
            } else if input.parse::<Option<Token![-]>>()?.is_some() {
                -1.0
            } else {
                return Ok(Self { terms });
            };
        }
    }
}

/// `p.z`, `0.5 p.z` or `0.5 * p.z`.
fn term(sign: f64, input: ParseStream<'_>) -> syn::Result<Term> {
    let factor = if is_literal(input) || input.peek(Token![-]) {
        let (span, factor) = (input.span(), number(input)?);
        if factor == 0.0 {
            return Err(Error::new(span, "the factor is zero; remove the term"));
        }
        input.parse::<Option<Token![*]>>()?;
        factor
    } else {
        1.0
    };
    let point = name(input)?;
    input.parse::<Token![.]>()?;
    Ok(Term {
        factor: sign * factor,
        point,
        axis: input.parse()?,
    })
}

impl Sum {
    /// Its points, each once.
    pub(super) fn points(&self) -> Vec<&Ident> {
        let mut points: Vec<&Ident> = Vec::new();
        for Term { point, .. } in &self.terms {
            if !points.contains(&point) {
                points.push(point);
            }
        }
        points
    }

    /// The point, if the sum is only one of its coordinates.
    pub(super) fn single(&self) -> Option<&Ident> {
        match self.terms.as_slice() {
            [term] if term.factor == 1.0 => Some(&term.point),
            _ => None,
        }
    }

    /// Checks the axes, and that no coordinate is repeated.
    pub(super) fn check(&self, check: &mut Check<'_>) {
        for (index, term) in self.terms.iter().enumerate() {
            check.axis(&term.axis);
            let is_same = |other: &Term| other.point == term.point && other.axis == term.axis;
            if self.terms.iter().take(index).any(is_same) {
                check.report(errors::same_point_twice(&term.point));
            }
        }
    }

    /// A text that is equal for two sums that are multiples of each other.
    pub(super) fn text(&self) -> String {
        let named = |term: &Term| (format!("{}.{}", term.point, term.axis), term.factor);
        let mut terms: Vec<(String, f64)> = self.terms.iter().map(named).collect();
        terms.sort_by(|(a, _), (b, _)| a.cmp(b));
        let unit = terms.first().map_or(1.0, |(_, factor)| *factor);
        let texts = terms
            .iter()
            .map(|(name, factor)| format!("{} {name}", factor / unit));
        texts.collect::<Vec<_>>().join(" + ")
    }

    /// The terms of its equation.
    pub(super) fn terms(&self, site: impl Fn(&Ident) -> Site) -> Vec<form::Term> {
        let terms = self.terms.iter().map(|term| form::Term {
            factor: term.factor,
            site: site(&term.point),
            axis: term.axis(),
        });
        terms.collect()
    }
}

impl Term {
    pub(super) fn axis(&self) -> usize {
        axis_index(&self.axis)
    }
}

pub(super) fn axis_index(axis: &Ident) -> usize {
    let mut axes = AXES.iter();
    axes.position(|name| axis == name).unwrap_or_default()
}

impl Check<'_> {
    /// Checks that a name is an axis.
    pub(super) fn axis(&mut self, axis: &Ident) {
        if !AXES.iter().any(|name| axis == name) {
            self.report(unknown_axis(axis));
        }
    }
}

fn unknown_axis(axis: &Ident) -> Error {
    errors::at(
        axis,
        format!("there is no axis `{axis}`; write `x`, `y` or `z`"),
    )
}
