//! `Bilinear`: a sum of products, which may define an unknown.

use nalgebra::{SMatrix, Vector3};
use suspension_core::Scalar;
use suspension_core::constraint;
use suspension_listing::form;
use suspension_listing::system::{SiteMotion, System};

use crate::plan::{LengthNames, LineLength};
use crate::site::{Site, Sites};
use crate::table::{SPARE, Table, index};

/// A sum of products: one row.
#[derive(Clone, Debug)]
pub(crate) struct Bilinear {
    pub(crate) row: u16,
    /// Its constant's place among those of all lengths that such sums are over.
    pub(crate) constant: u16,
    /// The unknown that it defines, and where the factors hold the derivative by it.
    defines: Option<[u16; 2]>,
    /// What stands beside the products, in lengths.
    beside: f64,
    products: Vec<Multiplied>,
    derivatives: Vec<Derivative>,
}

/// The lines over whose length, or geometric mean of lengths, products are.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Scale {
    pub(crate) lines: Vec<[Site; 2]>,
    /// What keeps the length of a single one.
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

/// By a variable, all that it is multiplied with.
#[derive(Clone, Debug)]
struct Derivative {
    of: Variable,
    /// Where the factors hold it.
    entry: u16,
    others: Vec<(f64, Factor)>,
}

#[derive(Clone, Copy, Debug)]
enum Variable {
    Unknown(u16),
    /// Of a chassis point.
    Input {
        site: Site,
        axis: usize,
        motion: SiteMotion,
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
    pub(crate) fn new(form: &form::Bilinear, lengths: &LengthNames<'_>) -> Self {
        let kept = match form.length.as_slice() {
            [line] => Some(lengths.of_line(line.each_ref())),
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
    /// `constant` is its constant's place.
    pub(crate) fn new(
        system: &System,
        form: &form::Bilinear,
        row: usize,
        constant: usize,
        entry: impl Fn(usize, Option<usize>) -> u16,
    ) -> Self {
        let factor = |factor: &form::Factor| Factor::new(system, factor);
        let defines = form.defines.as_ref().map(|name| {
            let column = system.scalar_column(name);
            [column.map_or(SPARE, index), entry(row, column)]
        });
        let derivatives = form.derivatives().into_iter().map(|(variable, others)| {
            let (of, column) = match variable {
                form::Variable::Unknown(name) => (
                    Variable::Unknown(unknown(system, name)),
                    system.scalar_column(name),
                ),
                form::Variable::Coordinate { site, axis } => {
                    let motion = site.motion;
                    let site = Site::from(site);
                    match site.column(axis) {
                        Some(column) => (Variable::Unknown(index(column)), Some(column)),
                        None => (Variable::Input { site, axis, motion }, None),
                    }
                }
            };
            let others = others.into_iter();
            Derivative {
                of,
                entry: entry(row, column),
                others: others.map(|(by, other)| (by, factor(other))).collect(),
            }
        });
        let products = form.products.iter().map(|product| Multiplied {
            by: product.by,
            factors: product.factors.each_ref().map(factor),
        });
        Self {
            row: index(row),
            constant: index(constant),
            defines,
            beside: form.constant,
            products: products.collect(),
            derivatives: derivatives.collect(),
        }
    }

    /// The unknown that it defines.
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
    pub(crate) fn residual<T: Scalar>(
        &self,
        constant: &constraint::Bilinear<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> T {
        let defined = self.defines.and_then(|[unknown, _]| sites.scalar(unknown));
        let beside = self.beside(constant);
        let linear = defined.into_iter().chain(beside);
        let linear = linear.reduce(|sum, term| sum + term);
        constant.residual(linear.unwrap_or_else(T::zero), self.factors(sites))
    }

    #[inline(always)]
    fn beside<T: Scalar>(&self, constant: &constraint::Bilinear<T>) -> Option<T> {
        (self.beside != 0.0).then(|| multiple(self.beside, constant.length()))
    }

    /// The unknown that it defines, from the others.
    pub(crate) fn defined<T: Scalar>(
        &self,
        constant: &constraint::Bilinear<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
    ) -> Option<(u16, T)> {
        let [unknown, _] = self.defines?;
        let beside = self.beside(constant).unwrap_or_else(T::zero);
        Some((unknown, -constant.residual(beside, self.factors(sites))))
    }

    #[inline(always)]
    pub(crate) fn curvature<T: Scalar, F: Table<Vector3<T>>>(
        &self,
        constant: &constraint::Bilinear<T>,
        v: &Sites<'_, T, F>,
        w: &Sites<'_, T, F>,
    ) -> T {
        let changes = self.factors(v).zip(self.factors(w));
        constant.curvature(changes.map(|(v, w)| [v, w]))
    }

    /// What chassis points with a motion contribute to the rates: `-dF/du udot`.
    #[inline(always)]
    pub(crate) fn input_rate<T: Scalar, F: Table<Vector3<T>>>(
        &self,
        constant: &constraint::Bilinear<T>,
        moved: SiteMotion,
        sites: &Sites<'_, T, F>,
        rates: &Sites<'_, T, F>,
    ) -> Option<T> {
        let mut sum = None;
        for derivative in &self.derivatives {
            match derivative.of {
                Variable::Input { site, axis, motion } if motion == moved => {
                    let term = derivative.value(constant, sites) * coordinate(rates, site, axis)?;
                    sum = Some(sum.map_or(-term, |sum| sum - term));
                }
                _ => {}
            }
        }
        sum
    }

    /// Writes the derivatives into the factors.
    #[inline(always)]
    pub(crate) fn write<T: Scalar>(
        &self,
        constant: &constraint::Bilinear<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        numbers: &mut impl Table<T>,
    ) {
        if let Some([_, entry]) = self.defines {
            *numbers.place(entry) = T::one();
        }
        for derivative in &self.derivatives {
            if let Variable::Unknown(_) = derivative.of {
                *numbers.place(derivative.entry) = derivative.value(constant, sites);
            }
        }
    }

    /// Writes the derivatives into a dense matrix.
    pub(crate) fn write_dense<T: Scalar, const N: usize>(
        &self,
        constant: &constraint::Bilinear<T>,
        sites: &Sites<'_, T, impl Table<Vector3<T>>>,
        matrix: &mut SMatrix<T, N, N>,
    ) {
        let mut put = |unknown: u16, value| {
            let place = (usize::from(self.row), usize::from(unknown));
            if let Some(entry) = matrix.get_mut(place) {
                *entry = value;
            }
        };
        if let Some([unknown, _]) = self.defines {
            put(unknown, T::one());
        }
        for derivative in &self.derivatives {
            if let Variable::Unknown(unknown) = derivative.of {
                put(unknown, derivative.value(constant, sites));
            }
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
