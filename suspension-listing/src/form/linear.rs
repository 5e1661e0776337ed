//! A prescribed sum of coordinates, or a prescribed scalar: `sum k x + s - drive`, or less what it is in the design.

use super::{Dependence, Equations};
use crate::name::Name;
use crate::site::Site;
use crate::vector::Vector;

#[derive(Clone, Debug)]
pub struct Linear {
    pub terms: Vec<Term>,
    pub scalar: Option<Name>,
    pub prescribed: Prescribed,
}

/// The source of the value of a sum.
#[derive(Clone, Debug)]
pub enum Prescribed {
    Drive(Name),
    /// The sum keeps its design value.
    Design,
}

/// A coordinate of a point, times a factor.
#[derive(Clone, Debug)]
pub struct Term {
    pub factor: f64,
    pub site: Site,
    pub axis: usize,
}

impl Equations for Linear {
    fn sites(&self) -> Vec<&Site> {
        self.terms.iter().map(|term| &term.site).collect()
    }

    fn scalars(&self) -> Vec<(&Name, Dependence)> {
        let scalar = self.scalar.iter();
        scalar.map(|name| (name, Dependence::Unit)).collect()
    }

    fn dependence(&self, _row: usize, site: usize, axis: usize) -> Dependence {
        let term = &self.terms[site];
        if term.axis != axis {
            Dependence::Never
        } else if term.factor == 1.0 {
            Dependence::Unit
        } else {
            Dependence::Any
        }
    }

    fn constants(&self, at: &[Vector]) -> Option<Vector> {
        Some(match self.prescribed {
            Prescribed::Drive(_) => [0.0; 3],
            Prescribed::Design => self.residual(&[0.0; 3], at, &[]),
        })
    }

    fn residual(&self, &[held, ..]: &Vector, at: &[Vector], scalars: &[f64]) -> Vector {
        let terms = self.terms.iter().zip(at);
        let sum: f64 = terms.map(|(term, at)| term.factor * at[term.axis]).sum();
        [sum + scalars.iter().sum::<f64>() - held, 0.0, 0.0]
    }

    fn drive(&self) -> Option<&Name> {
        match &self.prescribed {
            Prescribed::Drive(drive) => Some(drive),
            Prescribed::Design => None,
        }
    }
}
