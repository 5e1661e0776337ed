//! The fit of a segment: the polynomial of degree five that has given derivatives at given
//! places.
//!
//! The degree is five for every continuity: a cubic is looked up in three fifths of the time, but takes
//! three times the memory at 1e-6 m, and more at smaller tolerances.

use nalgebra::Vector3;

use crate::bake::driven::Derivatives;

/// The smoothness of a curve where segments join.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Continuity {
    /// Position is continuous: only positions are read.
    Position,
    /// Position and first derivative are continuous: velocities do not jump.
    Velocity,
    /// Position, first and second derivative are continuous: accelerations do not jump.
    Acceleration,
}

/// The number of coefficients of a segment, one more than its degree.
pub const TERMS: usize = 6;

/// Coefficients of three outputs over a segment, constants first.
pub(super) type Coefficients = [[f64; 3]; TERMS];

impl Continuity {
    /// The places in a segment, 0 to 1, where polynomial and motion meet, in order. If a place is listed again, they
    /// share one more derivative.
    ///
    /// The inner places make the extremes of the product of all `x - node` small: they are the Chebyshev points with
    /// the ends, or those for which the extremes are equal.
    fn nodes(self) -> [f64; TERMS] {
        match self {
            Self::Position => [
                0.0,
                0.095_491_502_812_526_27,
                0.345_491_502_812_526_3,
                0.654_508_497_187_473_7,
                0.904_508_497_187_473_7,
                1.0,
            ],
            Self::Velocity => [0.0, 0.0, 0.337_294, 0.662_706, 1.0, 1.0],
            Self::Acceleration => [0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
        }
    }

    /// The places in a segment, 0 to 1, at which the motion must be known.
    pub fn places(self) -> Vec<f64> {
        let mut places = self.nodes().to_vec();
        places.dedup();
        places
    }

    /// The polynomial over a segment of length `length` from the values at [`places`](Self::places): Newton's divided
    /// differences, multiplied out.
    pub fn fit(self, length: f64, values: &[Derivatives]) -> Coefficients {
        let mut coefficients = [Vector3::zeros(); TERMS];
        let differences = self.divided_differences(length, values);
        for (node, difference) in self.nodes().iter().zip(&differences).rev() {
            // p(x) becomes p(x) (x - node) + difference.
            for power in (1..TERMS).rev() {
                coefficients[power] = coefficients[power - 1] - coefficients[power] * *node;
            }
            coefficients[0] = difference - coefficients[0] * *node;
        }
        coefficients.map(Into::into)
    }

    /// `f[z0]`, `f[z0, z1]` and so on. For equal nodes they are derivatives.
    fn divided_differences(self, length: f64, values: &[Derivatives]) -> [Vector3<f64>; TERMS] {
        const FACTORIALS: [f64; 3] = [1.0, 1.0, 2.0];
        let (nodes, places) = (self.nodes(), self.places());
        let at = |node: f64, order: usize| {
            let place = places.iter().position(|place| *place == node);
            values[place.unwrap_or_default()][order] * length.powi(order as i32) / FACTORIALS[order]
        };
        let mut column = nodes.map(|node| at(node, 0));
        for order in 1..TERMS {
            for last in (order..TERMS).rev() {
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
