//! An angle about an axis, by sine `s` and cosine `c` of its quarter: `(s^2 + c^2 - L^2) / (2 L)`, with `L` the
//! geometric mean of its two lines' lengths in the design.

use super::{Dependence, Equations};
use crate::name::Name;
use crate::site::Site;
use crate::vector::{Vector, cross, dot, minus, norm};

#[derive(Clone, Debug)]
pub struct Turn {
    /// The line from which the angle is measured, the line to which it is measured, and the line about which it is.
    pub lines: [[Site; 2]; 3],
    /// The names of the unknowns.
    pub sine: Name,
    pub cosine: Name,
}

fn lines(at: &[Vector]) -> [Vector; 3] {
    [0, 2, 4].map(|from| minus(at[from + 1], at[from]))
}

/// The cosine and sine of half an angle from those of the angle, which is within half a turn. It uses square roots
/// only, so that C programs that read listings need no mathematics library.
fn half_angle([cosine, sine]: [f64; 2]) -> [f64; 2] {
    if cosine >= 0.0 {
        let half = ((1.0 + cosine) / 2.0).sqrt();
        [half, sine / (2.0 * half)]
    } else {
        let half = ((1.0 - cosine) / 2.0).sqrt().copysign(sine);
        [sine / (2.0 * half), half]
    }
}

impl Equations for Turn {
    fn sites(&self) -> Vec<&Site> {
        self.lines.iter().flatten().collect()
    }

    fn scalars(&self) -> Vec<(&Name, Dependence)> {
        [&self.sine, &self.cosine]
            .map(|name| (name, Dependence::Any))
            .to_vec()
    }

    fn scalars_at(&self, at: &[Vector], _known: &[f64]) -> Option<Vec<f64>> {
        let [length, ..] = self.constants(at)?;
        let [d, e, n] = lines(at);
        let normal = cross(n, d);
        let along = dot(normal, cross(n, e)) / norm(n);
        let across = dot(normal, e);
        let radius = (along * along + across * across).sqrt();
        let [cosine, sine] = half_angle(half_angle([along / radius, across / radius]));
        Some(vec![length * sine, length * cosine])
    }

    fn dependence(&self, _row: usize, _site: usize, _axis: usize) -> Dependence {
        Dependence::Never
    }

    /// The length.
    fn constants(&self, at: &[Vector]) -> Option<Vector> {
        let [d, e, n] = lines(at);
        let is_seen = [d, e].map(|line| norm(cross(n, line)) > 0.0);
        let length = (norm(d) * norm(e)).sqrt();
        (is_seen == [true; 2]).then_some([length, 0.0, 0.0])
    }

    fn residual(&self, &[length, ..]: &Vector, _at: &[Vector], scalars: &[f64]) -> Vector {
        let square: f64 = scalars.iter().map(|part| part * part).sum();
        [(square / length - length) / 2.0, 0.0, 0.0]
    }
}
