//! Products over a length `L`: `z + k L + sum f u v / L`, with `z`, where there is one, an unknown that it defines,
//! and `u` and `v` other unknowns or coordinates of lines.

use super::{Dependence, Equations};
use crate::name::Name;
use crate::site::Site;
use crate::vector::{Vector, dot, minus};

#[derive(Clone, Debug)]
pub struct Bilinear {
    pub defines: Option<Name>,
    /// The constant term beside the products, in lengths `L`.
    pub constant: f64,
    pub products: Vec<Multiplied>,
    /// The lines whose length, or geometric mean of lengths, is `L`. With one line, `L` is the length that the
    /// line keeps, whatever the lengths are; with two it is the mean in the design.
    pub length: Vec<[Site; 2]>,
}

/// A product of two factors, times a constant.
#[derive(Clone, Debug)]
pub struct Multiplied {
    pub by: f64,
    pub factors: [Factor; 2],
}

#[derive(Clone, Debug, PartialEq)]
pub enum Factor {
    Unknown(Name),
    /// A coordinate of a line.
    Edge {
        line: [Site; 2],
        axis: usize,
    },
}

/// The variable of a derivative.
#[derive(Clone, Debug, PartialEq)]
pub enum Variable<'a> {
    Unknown(&'a Name),
    Coordinate { site: &'a Site, axis: usize },
}

impl Factor {
    /// The variables that it consists of, each with its sign.
    fn variables(&self) -> Vec<(f64, Variable<'_>)> {
        match self {
            Self::Unknown(name) => vec![(1.0, Variable::Unknown(name))],
            Self::Edge { line, axis } => {
                let [from, to] = line
                    .each_ref()
                    .map(|site| Variable::Coordinate { site, axis: *axis });
                vec![(1.0, to), (-1.0, from)]
            }
        }
    }
}

impl Bilinear {
    /// For each variable, in order of appearance, the factors that it is multiplied by.
    pub fn derivatives(&self) -> Vec<(Variable<'_>, Vec<(f64, &Factor)>)> {
        let mut derivatives: Vec<(Variable<'_>, Vec<(f64, &Factor)>)> = Vec::new();
        for Multiplied { by, factors } in &self.products {
            let [u, v] = factors;
            for (factor, other) in [(u, v), (v, u)] {
                for (sign, variable) in factor.variables() {
                    let term = (sign * by, other);
                    match derivatives.iter_mut().find(|(by, _)| *by == variable) {
                        Some((_, terms)) => terms.push(term),
                        None => derivatives.push((variable, vec![term])),
                    }
                }
            }
        }
        derivatives
    }

    fn factors(&self) -> impl Iterator<Item = &Factor> {
        self.products.iter().flat_map(|product| &product.factors)
    }

    fn values<'a>(&'a self, at: &[Vector], scalars: &[f64]) -> Values<'a> {
        let names = self.scalars().into_iter().map(|(name, _)| name);
        Values {
            sites: self.sites().into_iter().zip(at.iter().copied()).collect(),
            scalars: names.zip(scalars.iter().copied()).collect(),
        }
    }
}

/// Sites and scalars with their values.
struct Values<'a> {
    sites: Vec<(&'a Site, Vector)>,
    scalars: Vec<(&'a Name, f64)>,
}

impl Values<'_> {
    fn value(&self, factor: &Factor) -> f64 {
        match factor {
            Factor::Unknown(name) => {
                let known = self.scalars.iter().find(|(other, _)| *other == name);
                known.map_or(0.0, |(_, value)| *value)
            }
            Factor::Edge { line, axis } => self.line(line)[*axis],
        }
    }

    fn line(&self, line: &[Site; 2]) -> Vector {
        let [from, to] = line.each_ref().map(|end| {
            let place = self.sites.iter().find(|(site, _)| site.name == end.name);
            place.map_or([0.0; 3], |(_, at)| *at)
        });
        minus(to, from)
    }
}

impl Equations for Bilinear {
    fn sites(&self) -> Vec<&Site> {
        let of_factors = self.factors().filter_map(|factor| match factor {
            Factor::Edge { line, .. } => Some(line),
            Factor::Unknown(_) => None,
        });
        let mut sites: Vec<&Site> = Vec::new();
        for site in self.length.iter().chain(of_factors).flatten() {
            if !sites.iter().any(|other| other.name == site.name) {
                sites.push(site);
            }
        }
        sites
    }

    fn scalars(&self) -> Vec<(&Name, Dependence)> {
        let defined = self.defines.iter().map(|name| (name, Dependence::Unit));
        let mut scalars: Vec<(&Name, Dependence)> = defined.collect();
        for factor in self.factors() {
            if let Factor::Unknown(name) = factor
                && !scalars.iter().any(|(other, _)| *other == name)
            {
                scalars.push((name, Dependence::Any));
            }
        }
        scalars
    }

    /// The unknown that it defines, from the others.
    fn scalars_at(&self, at: &[Vector], known: &[f64]) -> Option<Vec<f64>> {
        self.defines.as_ref()?;
        let mut scalars = known.to_vec();
        *scalars.first_mut()? = 0.0;
        let [rest, ..] = self.residual(&self.constants(at)?, at, &scalars);
        *scalars.first_mut()? = -rest;
        Some(scalars)
    }

    fn dependence(&self, _row: usize, site: usize, axis: usize) -> Dependence {
        let sites = self.sites();
        let depends = |(variable, _): &(Variable<'_>, Vec<(f64, &Factor)>)| {
            matches!(variable, Variable::Coordinate { site: of, axis: along }
                if of.name == sites[site].name && *along == axis)
        };
        if self.derivatives().iter().any(depends) {
            Dependence::Any
        } else {
            Dependence::Never
        }
    }

    /// The length.
    fn constants(&self, at: &[Vector]) -> Option<Vector> {
        let values = self.values(at, &[]);
        let lines = self.length.iter().map(|line| values.line(line));
        let squares = lines.map(|line| dot(line, line));
        let product: f64 = squares.map(f64::sqrt).product();
        let length = match self.length.as_slice() {
            [_, _] => product.sqrt(),
            _ => product,
        };
        (length > 0.0).then_some([length, 0.0, 0.0])
    }

    fn residual(&self, &[length, ..]: &Vector, at: &[Vector], scalars: &[f64]) -> Vector {
        let values = self.values(at, scalars);
        let products = self.products.iter().map(|Multiplied { by, factors }| {
            let [u, v] = factors.each_ref().map(|factor| values.value(factor));
            by * u * v
        });
        let sum: f64 = products.sum();
        let defined = self.defines.as_ref().and(scalars.first()).copied();
        let linear = defined.unwrap_or_default() + self.constant * length;
        [linear + sum / length, 0.0, 0.0]
    }
}
