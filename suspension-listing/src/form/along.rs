//! A point on the line from one point to another, or in the plane of two such lines: `p - o - sum s_k e_k / L_k`,
//! with `e_k` from `o` to the line's other end, `L_k` its length in the design, and `s_k`, an unknown, the distance
//! along it.

use super::{Dependence, Equations};
use crate::name::Name;
use crate::site::Site;
use crate::vector::{Vector, combined, cross, dot, minus};

#[derive(Clone, Debug)]
pub struct Along {
    /// The start of the lines.
    pub from: Site,
    /// The other end of one line, or of two.
    pub ends: Vec<Site>,
    pub point: Site,
    /// The names of the unknowns, one per line.
    pub distances: Vec<Name>,
}

/// The vectors of the lines, and the vector to the point from their start.
fn edges(at: &[Vector]) -> (Vec<Vector>, Vector) {
    let mut edges: Vec<Vector> = at[1..].iter().map(|end| minus(*end, at[0])).collect();
    let point = edges.pop().unwrap_or_default();
    (edges, point)
}

fn length(edge: &Vector) -> f64 {
    dot(*edge, *edge).sqrt()
}

impl Equations for Along {
    fn sites(&self) -> Vec<&Site> {
        let from = [&self.from].into_iter();
        from.chain(&self.ends).chain([&self.point]).collect()
    }

    fn scalars(&self) -> Vec<(&Name, Dependence)> {
        let distances = self.distances.iter();
        distances.map(|name| (name, Dependence::Any)).collect()
    }

    fn scalars_at(&self, at: &[Vector], _known: &[f64]) -> Option<Vec<f64>> {
        let (lines, d) = edges(at);
        Some(match lines.as_slice() {
            [u, v] => {
                let normal = cross(*u, *v);
                let shares = [(cross(d, *v), u), (cross(*u, d), v)];
                let per_area = 1.0 / dot(normal, normal);
                shares
                    .map(|(share, edge)| dot(share, normal) * per_area * length(edge))
                    .to_vec()
            }
            lines => lines.iter().map(|e| dot(d, *e) / length(e)).collect(),
        })
    }

    fn rows(&self) -> usize {
        3
    }

    fn dependence(&self, row: usize, site: usize, axis: usize) -> Dependence {
        if row != axis {
            Dependence::Never
        } else if site > self.ends.len() {
            Dependence::Unit
        } else {
            Dependence::Any
        }
    }

    /// The lengths.
    fn constants(&self, at: &[Vector]) -> Option<Vector> {
        let (lines, _) = edges(at);
        let mut lengths = [0.0; 3];
        for (place, line) in lengths.iter_mut().zip(&lines) {
            *place = length(line);
        }
        let spanned = match lines.as_slice() {
            [u, v] => length(&cross(*u, *v)),
            _ => lengths[0],
        };
        (spanned > 0.0).then_some(lengths)
    }

    fn residual(&self, lengths: &Vector, at: &[Vector], distances: &[f64]) -> Vector {
        let (lines, d) = edges(at);
        let shares = distances.iter().zip(lengths).map(|(s, length)| s / length);
        minus(d, combined(shares.zip(lines)))
    }
}
