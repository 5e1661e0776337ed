//! Two points a constant length apart: `(|d|^2 - L^2) / (2 L)`.

use super::Equations;
use crate::site::Site;
use crate::vector::{Vector, dot, minus};

/// A constant distance. If one end is on the chassis, it is `from`.
#[derive(Clone, Debug)]
pub struct Distance {
    pub from: Site,
    pub to: Site,
}

impl Equations for Distance {
    fn sites(&self) -> Vec<&Site> {
        vec![&self.from, &self.to]
    }

    fn constants(&self, at: &[Vector]) -> Option<Vector> {
        let d = minus(at[1], at[0]);
        let length = dot(d, d).sqrt();
        (length > 0.0).then_some([length, 0.0, 0.0])
    }

    fn residual(&self, &[length, ..]: &Vector, at: &[Vector], _scalars: &[f64]) -> Vector {
        let d = minus(at[1], at[0]);
        [(dot(d, d) / length - length) / 2.0, 0.0, 0.0]
    }

    fn keeps(&self) -> Option<[&Site; 2]> {
        Some([&self.from, &self.to])
    }
}
