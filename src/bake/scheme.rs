//! How a segment is fitted: the polynomial that has given derivatives at given places.

use nalgebra::Vector3;

use crate::bake::path::Derivatives;

/// How smooth a curve is where segments join.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Continuity {
    /// Position: what is read is positions.
    Position,
    /// Position and first derivative: velocities do not jump.
    Velocity,
    /// Position, first and second derivative: accelerations do not jump.
    Acceleration,
}

impl Continuity {
    /// The places in a segment, 0 to 1, where polynomial and motion meet, in order. Where a place
    /// is listed again they share one more derivative.
    fn nodes(self) -> &'static [f64] {
        match self {
            Self::Position => &[0.0, 0.25, 0.75, 1.0],
            Self::Velocity => &[0.0, 0.0, 1.0, 1.0],
            Self::Acceleration => &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
        }
    }

    /// Coefficients of a segment: one more than the degree.
    pub fn terms(self) -> usize {
        self.nodes().len()
    }

    /// The places in a segment, 0 to 1, at which the motion must be known.
    pub fn places(self) -> Vec<f64> {
        let mut places = self.nodes().to_vec();
        places.dedup();
        places
    }

    /// The coefficients of an output over a segment of length `length`, constants first, from its
    /// values at [`places`](Self::places): Newton's divided differences, multiplied out.
    pub fn fit(self, length: f64, values: &[Derivatives]) -> Vec<[f64; 3]> {
        let mut coefficients = vec![Vector3::zeros(); self.terms()];
        let differences = self.divided_differences(length, values);
        for (node, difference) in self.nodes().iter().zip(&differences).rev() {
            // p(x) becomes p(x) (x - node) + difference.
            for power in (1..coefficients.len()).rev() {
                coefficients[power] = coefficients[power - 1] - coefficients[power] * *node;
            }
            coefficients[0] = difference - coefficients[0] * *node;
        }
        coefficients.into_iter().map(Into::into).collect()
    }

    /// `f[z0]`, `f[z0, z1]` and so on. Over equal nodes they are derivatives.
    fn divided_differences(self, length: f64, values: &[Derivatives]) -> Vec<Vector3<f64>> {
        const FACTORIALS: [f64; 3] = [1.0, 1.0, 2.0];
        let (nodes, places) = (self.nodes(), self.places());
        let at = |node: f64, order: usize| {
            let place = places.iter().position(|place| *place == node);
            values[place.unwrap_or_default()][order] * length.powi(order as i32) / FACTORIALS[order]
        };
        let mut column: Vec<_> = nodes.iter().map(|node| at(*node, 0)).collect();
        for order in 1..nodes.len() {
            for last in (order..nodes.len()).rev() {
                let width = nodes[last] - nodes[last - order];
                column[last] = if width == 0.0 {
                    at(nodes[last], order)
                } else {
                    (column[last] - column[last - 1]) / width
                };
            }
        }
        column
    }
}
