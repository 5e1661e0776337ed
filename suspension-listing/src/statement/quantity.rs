//! Quantities, which drives prescribe and measures read: sums of coordinates, `p along [0.1, 1.0, 0.0]`,
//! `angle(p -> q, z)`, `angle(p -> q, r -> s)`, `length(p -> q)`.

mod parse;

use syn::Ident;
use syn::parse::ParseStream;

use super::sum::{Sum, Term, axis_index};
use crate::errors;
use crate::form;
use crate::listing::Check;
use crate::name::Name;
use crate::system::{self, Site};
use crate::vector::Vector;

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
        parse::quantity(input)
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
                    check.report(errors::line_is_axis(from, to));
                }
            }
            Self::Length { .. } | Self::Along { .. } => {}
        }
    }

    /// A text that is equal for two quantities that differ only in sign and a constant.
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
                // Adding zero turns -0 into 0.
                let direction = direction.map(|factor| sign * factor + 0.0);
                format!("along {direction:?} {point}")
            }
        }
    }

    /// The coordinates whose sum the equation of a drive prescribes.
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

    /// The same quantity without places in the source.
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
