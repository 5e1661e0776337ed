//! Two points an unknown length `s` apart: `(|d|^2 - s^2) / (2 L)`, with `L` the length in the design.

use super::{Dependence, Equations};
use crate::name::Name;
use crate::site::Site;
use crate::vector::{Vector, dot, minus};

#[derive(Clone, Debug)]
pub struct Stretch {
    pub from: Site,
    pub to: Site,
    /// The unknown's name.
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

    fn scalar(&self) -> Option<(&Name, Dependence)> {
        Some((&self.length, Dependence::Any))
    }

    fn scalar_at(&self, at: &[Vector]) -> Option<f64> {
        Some(length(at))
    }

    fn dependence(&self, _row: usize, _site: usize, _axis: usize) -> Dependence {
        Dependence::Any
    }

    fn constants(&self, at: &[Vector]) -> Option<Vector> {
        let length = length(at);
        (length > 0.0).then_some([length, 0.0, 0.0])
    }

    fn residual(&self, &[scale, ..]: &Vector, at: &[Vector], s: f64) -> Vector {
        let d = minus(at[1], at[0]);
        [(dot(d, d) - s * s) / (2.0 * scale), 0.0, 0.0]
    }
}
