//! Two points an unknown length `s` apart: `(|d|^2 - s^2) / (2 L)`, with `L` the length in the design.

use super::{Dependence, Equations};
use crate::name::Name;
use crate::site::Site;
use crate::vector::{Vector, dot, minus};

#[derive(Clone, Debug)]
pub struct Stretch {
    pub from: Site,
    pub to: Site,
    /// The name of the unknown.
    pub length: Name,
}

fn length(at: &[Vector]) -> f64 {
    let d = minus(at[1], at[0]);
    dot(d, d).sqrt()
}

impl Equations for Stretch {
    fn sites(&self) -> Vec<&Site> {
        vec![&self.from, &self.to]
    }

    fn scalars(&self) -> Vec<(&Name, Dependence)> {
        vec![(&self.length, Dependence::Any)]
    }

    fn scalars_at(&self, at: &[Vector], _known: &[f64]) -> Option<Vec<f64>> {
        Some(vec![length(at)])
    }

    fn constants(&self, at: &[Vector]) -> Option<Vector> {
        let length = length(at);
        (length > 0.0).then_some([length, 0.0, 0.0])
    }

    fn residual(&self, &[scale, ..]: &Vector, at: &[Vector], scalars: &[f64]) -> Vector {
        let s: f64 = scalars.iter().sum();
        let d = minus(at[1], at[0]);
        [(dot(d, d) - s * s) / (2.0 * scale), 0.0, 0.0]
    }
}
