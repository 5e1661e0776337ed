//! Two lines of constant lengths at an angle that stays: `(d . e - c |d| |e|) / (|d| + |e|)`.

use super::Equations;
use crate::site::Site;
use crate::vector::{Vector, dot, minus};

#[derive(Clone, Debug)]
pub struct Product {
    /// The start and end of each line.
    pub lines: [[Site; 2]; 2],
}

fn lines(at: &[Vector]) -> [Vector; 2] {
    [minus(at[1], at[0]), minus(at[3], at[2])]
}

impl Equations for Product {
    fn sites(&self) -> Vec<&Site> {
        self.lines.iter().flatten().collect()
    }

    /// `d . e` and `|d| + |e|`.
    fn constants(&self, at: &[Vector]) -> Option<Vector> {
        let lines = lines(at);
        let [d, e] = lines;
        let [of_d, of_e] = lines.map(|line| dot(line, line).sqrt());
        (of_d > 0.0 && of_e > 0.0).then_some([dot(d, e), of_d + of_e, 0.0])
    }

    fn residual(&self, &[kept, scale, _]: &Vector, at: &[Vector], _scalars: &[f64]) -> Vector {
        let [d, e] = lines(at);
        [(dot(d, e) - kept) / scale, 0.0, 0.0]
    }
}
