//! A general plane in the place of a given coordinate's.

use nalgebra::{Complex, SMatrix};

use crate::assemblies::factors::Vector;

/// What is added to the equation of a drive, or of an unknown that is given: `f(q; u) + p d.q`, with general `d`.
///
/// Without that equation the roots form a curve, which a value of the coordinate cuts in a plane. Planes of one coordinate
/// are special: a curve may run off to infinity along them. Then they cut it in fewer points than its degree, and the sum of
/// these is not linear in its place although none is missing. A general plane cuts it in as many points as its degree,
/// and their sum is linear (Sommese, Verschelde and Wampler 2002).
pub(crate) struct Tilt<const N: usize> {
    /// The row of the equation.
    pub(crate) row: usize,
    /// `d`.
    direction: Vector<N>,
}

impl<const N: usize> Tilt<N> {
    pub(crate) fn new(row: usize, direction: Vector<N>) -> Self {
        Self { row, direction }
    }

    /// Adds `p d.q` to right-hand sides or residuals.
    pub(crate) fn add(&self, part: f64, q: &Vector<N>, rows: &mut Vector<N>) {
        rows[self.row] += self.direction.dot(q) * part;
    }

    /// Adds `p d` to the Jacobian.
    pub(crate) fn add_gradient(&self, part: f64, jacobian: &mut SMatrix<Complex<f64>, N, N>) {
        let row = jacobian.row_mut(self.row).into_iter();
        for (entry, direction) in row.zip(&self.direction) {
            *entry += direction * Complex::from(part);
        }
    }
}
