//! A point carried by the frame of a body: `p - (o + a u + b v + c u x v)`.

use super::{Dependence, Equations};
use crate::name::Name;
use crate::site::Site;
use crate::vector::{Vector, combined, cross, dot, minus};

#[derive(Clone, Debug)]
pub struct Carried {
    pub body: Name,
    pub frame: [Site; 3],
    pub point: Site,
}

/// The edges of the frame, and the vector to the point from its origin.
fn edges(at: &[Vector]) -> [Vector; 3] {
    [
        minus(at[1], at[0]),
        minus(at[2], at[0]),
        minus(at[3], at[0]),
    ]
}

impl Equations for Carried {
    fn sites(&self) -> Vec<&Site> {
        self.frame.iter().chain([&self.point]).collect()
    }

    fn rows(&self) -> usize {
        3
    }

    fn dependence(&self, row: usize, site: usize, axis: usize) -> Dependence {
        match site {
            3 if row == axis => Dependence::Unit,
            3 => Dependence::Never,
            _ => Dependence::Any,
        }
    }

    /// `a`, `b`, `c` of `d = a u + b v + c u x v`.
    fn constants(&self, at: &[Vector]) -> Option<Vector> {
        let [u, v, d] = edges(at);
        let normal = cross(u, v);
        let area_squared = dot(normal, normal);
        let parts = [
            dot(cross(d, v), normal),
            dot(cross(u, d), normal),
            dot(d, normal),
        ];
        (area_squared > 0.0).then_some(parts.map(|part| part / area_squared))
    }

    fn residual(&self, &[a, b, c]: &Vector, at: &[Vector], _scalars: &[f64]) -> Vector {
        let [u, v, d] = edges(at);
        minus(d, combined([(a, u), (b, v), (c, cross(u, v))]))
    }

    fn carries(&self) -> Option<&Carried> {
        Some(self)
    }
}
