//! The Jacobian's numbers in the design position that a listing states, and around it: what the
//! choice of pivots goes by. Nothing of it is emitted.

mod path;

use std::collections::BTreeMap;

use syn::Ident;

use crate::system::{Equation, Site};

pub use path::positions;

type Vector = [f64; 3];

/// The design position of each point that has one.
pub type Design = BTreeMap<String, Vector>;

/// `dF/d point.axis` of one row of an equation; `None` where a position is missing, or the
/// geometry is degenerate.
pub fn derivative(
    equation: &Equation,
    row: usize,
    point: &Ident,
    axis: usize,
    design: &Design,
) -> Option<f64> {
    let at = |site: &Site| design.get(&site.name.to_string()).copied();
    let value = match equation {
        Equation::Distance { from, to, .. } => {
            let d = minus(at(to)?, at(from)?);
            let sign = if *point == to.name { 1.0 } else { -1.0 };
            sign * d[axis] / dot(d, d).sqrt()
        }
        Equation::Carried {
            point: carried,
            frame,
            ..
        } => {
            let [origin, second, third] = [at(&frame[0])?, at(&frame[1])?, at(&frame[2])?];
            let (u, v) = (minus(second, origin), minus(third, origin));
            let [a, b, c] = constants(u, v, minus(at(carried)?, origin));
            let identity = f64::from(u8::from(row == axis));
            let by_second = c * cross_matrix(v, row, axis) - a * identity;
            let by_third = -c * cross_matrix(u, row, axis) - b * identity;
            match frame.iter().position(|site| site.name == *point) {
                Some(0) => -(identity + by_second + by_third),
                Some(1) => by_second,
                Some(_) => by_third,
                None => identity,
            }
        }
        Equation::Coordinate { of, .. } => {
            if *point == of.name {
                1.0
            } else {
                -1.0
            }
        }
    };
    value.is_finite().then_some(value)
}

/// `a`, `b`, `c` of `d = a u + b v + c u x v`.
fn constants(u: Vector, v: Vector, d: Vector) -> Vector {
    let normal = cross(u, v);
    let area_squared = dot(normal, normal);
    [
        dot(cross(d, v), normal),
        dot(cross(u, d), normal),
        dot(d, normal),
    ]
    .map(|x| x / area_squared)
}

/// An entry of the matrix that takes `w` to `v x w`.
fn cross_matrix(v: Vector, row: usize, column: usize) -> f64 {
    let mut w = [0.0; 3];
    w[column] = 1.0;
    cross(v, w)[row]
}

fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
