//! A point on the line through two others: `p - o - s e / L`, with `e` from `o` to the other end, `L` its
//! length, which does not change, and `s`, an unknown, the distance from `o` to `p`.

use super::{Dependence, Equations};
use crate::name::Name;
use crate::site::Site;
use crate::vector::{Vector, combined, dot, minus};

#[derive(Clone, Debug)]
pub struct Along {
    pub line: [Site; 2],
    pub point: Site,
    /// The unknown's name.
    pub distance: Name,
}

/// The line, and the point from its start.
fn edges(at: &[Vector]) -> [Vector; 2] {
    [minus(at[1], at[0]), minus(at[2], at[0])]
}

impl Equations for Along {
    fn sites(&self) -> Vec<&Site> {
        self.line.iter().chain([&self.point]).collect()
    }

    fn scalar(&self) -> Option<(&Name, Dependence)> {
        Some((&self.distance, Dependence::Any))
    }

    fn scalar_at(&self, at: &[Vector]) -> Option<f64> {
        let [e, d] = edges(at);
        Some(dot(d, e) / dot(e, e).sqrt())
    }

    fn rows(&self) -> usize {
        3
    }

    fn dependence(&self, row: usize, site: usize, axis: usize) -> Dependence {
        match site {
            _ if row != axis => Dependence::Never,
            2 => Dependence::Unit,
            _ => Dependence::Any,
        }
    }

    fn constants(&self, at: &[Vector]) -> Option<Vector> {
        let [e, _] = edges(at);
        let length = dot(e, e).sqrt();
        (length > 0.0).then_some([length, 0.0, 0.0])
    }

    fn residual(&self, &[length, ..]: &Vector, at: &[Vector], s: f64) -> Vector {
        let [e, d] = edges(at);
        minus(d, combined([(s / length, e)]))
    }
}
