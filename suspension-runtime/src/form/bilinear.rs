//! `Bilinear`: a sum of products, which may define an unknown.

use nalgebra::Vector3;
use suspension_core::Scalar;
use suspension_core::model::constraint;
use suspension_listing::form;
use suspension_listing::system::System;

use super::{Entries, Place, Walked};
use crate::plan::lengths::LineLength;
use crate::site::{Inputs, Site, Sites};
use crate::table::{SPARE, Table, index, put, put_sum};

/// A sum of products: one row.
#[derive(Clone, Debug)]
pub(crate) struct Bilinear {
    pub(crate) row: u16,
    /// The index of its constant among those of all lengths by which such sums are divided.
    pub(crate) constant: u16,
    /// The unknown that it defines, and the place of the derivative with respect to it.
    defines: Option<[u16; 2]>,
    /// The constant term beside the products, as a multiple of the length.
    beside: f64,
    products: Vec<Multiplied>,
    derivatives: Vec<Derivative>,
}

/// The lines by whose length, or geometric mean of lengths, products are divided.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Scale {
    pub(crate) lines: Vec<[Site; 2]>,
    /// The part that keeps the length, if there is a single line.
    pub(crate) kept: Option<LineLength>,
}

#[derive(Clone, Copy, Debug)]
struct Multiplied {
    by: f64,
    factors: [Factor; 2],
}

#[derive(Clone, Copy, Debug)]
enum Factor {
    Unknown(u16),
    Edge { line: [Site; 2], axis: usize },
}

/// The derivative with respect to a variable: all the factors that multiply it.
#[derive(Clone, Debug)]
struct Derivative {
    of: Variable,
    /// The place where it is stored.
    entry: u16,
    others: Vec<(f64, Factor)>,
}

#[derive(Clone, Copy, Debug)]
enum Variable {
    Unknown,
    /// A coordinate of a chassis point.
    Input {
        site: Site,
        axis: usize,
    },
}

impl Factor {
    fn new(system: &System, factor: &form::Factor) -> Self {
        match factor {
            form::Factor::Unknown(name) => Self::Unknown(unknown(system, name)),
            form::Factor::Edge { line, axis } => Self::Edge {
                line: line.each_ref().map(Site::from),
                axis: *axis,
            },
        }
    }

    #[inline(always)]
    fn value<T: Scalar>(&self, sites: &Sites<'_, T, impl Table<Vector3<T>>>) -> Option<T> {
        match self {
            Self::Unknown(unknown) => sites.scalar(*unknown),
            Self::Edge { line, axis } => {
                let [from, to] = line.map(|site| coordinate(sites, site, *axis));
                Some(to? - from?)
            }
        }
    }
}

fn unknown(system: &System, name: &suspension_listing::name::Name) -> u16 {
    system.scalar_column(name).map_or(SPARE, index)
}

#[inline(always)]
fn coordinate<T: Scalar>(
    sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    site: Site,
    axis: usize,
) -> Option<T> {
    sites.get(site)?.iter().nth(axis).copied()
}

/// The number, times a factor.
#[inline(always)]
fn multiple<T: Scalar>(by: f64, number: T) -> T {
    T::constant(by) * number
}

impl Scale {
    pub(super) fn new(form: &form::Bilinear, place: &Place<'_>) -> Self {
        let kept = match form.length.as_slice() {
            [line] => Some(place.lengths.line_length(line.each_ref())),
            _ => None,
        };
        let lines = form.length.iter();
        Self {
            lines: lines.map(|line| line.each_ref().map(Site::from)).collect(),
            kept,
        }
    }
}

impl Bilinear {
    /// `constant` is the index of its constant.
    pub(super) fn new(form: &form::Bilinear, place: &Place<'_>, constant: usize) -> Self {
        let system = place.system;
        let factor = |factor: &form::Factor| Factor::new(system, factor);
        let defines = form.defines.as_ref().map(|name| {
            let column = system.scalar_column(name);
            [column.map_or(SPARE, index), place.entry(0, column)]
        });
        let derivatives = form.derivatives().into_iter().map(|(variable, others)| {
            let (of, column) = match variable {
                form::Variable::Unknown(name) => (Variable::Unknown, system.scalar_column(name)),
                form::Variable::Coordinate { site, axis } => {
                    let site = Site::from(site);
                    match site.column(axis) {
                        Some(column) => (Variable::Unknown, Some(column)),
                        None => (Variable::Input { site, axis }, None),
                    }
                }
            };
            let others = others.into_iter();
            Derivative {
                of,
                entry: place.entry(0, column),
                others: others.map(|(by, other)| (by, factor(other))).collect(),
            }
        });
        let products = form.products.iter().map(|product| Multiplied {
            by: product.by,
            factors: product.factors.each_ref().map(factor),
        });
        Self {
            row: index(place.row),
            constant: index(constant),
            defines,
            beside: form.constant,
            products: products.collect(),
            derivatives: derivatives.collect(),
        }
    }

    /// The unknown that it defines.
    #[inline(always)]
    pub(crate) fn unknown(&self) -> Option<u16> {
        self.defines.map(|[unknown, _]| unknown)
    }

    /// Both factors of each product.
    #[inline(always)]
    fn factors<T: Scalar>(
        &self,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> impl Iterator<Item = (T, T)> {
        self.products
            .iter()
            .filter_map(|Multiplied { by, factors }| {
                let [u, v] = factors.map(|factor| factor.value(sites));
                Some((multiple(*by, u?), v?))
            })
    }

    #[inline(always)]
    fn constant_term<T: Scalar>(&self, constant: &constraint::Bilinear<T>) -> Option<T> {
        (self.beside != 0.0).then(|| multiple(self.beside, constant.length()))
    }
}

impl<T: Scalar, F: Table<Vector3<T>>> Walked<T, F> for Bilinear {
    type Constant = constraint::Bilinear<T>;

    #[inline(always)]
    fn residual(&self, constant: &Self::Constant, at: &Sites<'_, T, F>, rows: &mut [T]) {
        let defined = self.unknown().and_then(|unknown| at.scalar(unknown));
        let linear = defined.into_iter().chain(self.constant_term(constant));
        let linear = linear.reduce(|sum, term| sum + term);
        let linear = linear.unwrap_or_else(T::zero);
        put(rows, self.row, constant.residual(linear, self.factors(at)));
    }

    #[inline(always)]
    fn gradient(&self, constant: &Self::Constant, at: &Sites<'_, T, F>, to: &mut impl Entries<T>) {
        if let Some([_, entry]) = self.defines {
            to.put(entry, T::one());
        }
        for derivative in &self.derivatives {
            if let Variable::Unknown = derivative.of {
                to.put(derivative.entry, derivative.value(constant, at));
            }
        }
    }

    #[inline(always)]
    fn curvature(&self, constant: &Self::Constant, [v, w]: [&Sites<'_, T, F>; 2], rows: &mut [T]) {
        let changes = self.factors(v).zip(self.factors(w));
        let curvature = constant.curvature(changes.map(|(v, w)| [v, w]));
        put(rows, self.row, curvature);
    }

    #[inline(never)]
    fn input_rate(&self, constant: &Self::Constant, inputs: &Inputs<'_, T, F>, rows: &mut [T]) {
        let terms = self.derivatives.iter().filter_map(|derivative| {
            let Variable::Input { site, axis } = derivative.of else {
                return None;
            };
            let rate = inputs.rate(site)?.iter().nth(axis).copied()?;
            Some(-(derivative.value(constant, &inputs.at) * rate))
        });
        put_sum(rows, self.row, terms);
    }

    fn put_scalars(&self, constant: &Self::Constant, q: &mut [T], fixed: &F) {
        let beside = self.constant_term(constant).unwrap_or_else(T::zero);
        let defined = -constant.residual(beside, self.factors(&Sites::new(q, fixed)));
        if let Some(unknown) = self.unknown() {
            put(q, unknown, defined);
        }
    }
}

impl Derivative {
    #[inline(always)]
    fn value<T: Scalar>(
        &self,
        constant: &constraint::Bilinear<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> T {
        let others = self.others.iter();
        let others = others.filter_map(|(by, other)| Some(multiple(*by, other.value(sites)?)));
        constant.gradient(others)
    }
}
