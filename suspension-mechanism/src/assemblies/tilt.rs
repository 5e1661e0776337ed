//! General planes in place of the plane of a given coordinate.

use nalgebra::{Complex, SMatrix};

use crate::assemblies::factors::Vector;
use crate::assemblies::random::Random;

/// The terms added to the equation of a drive, or of a given unknown: `f(q; u) + p d.q - t h(q)`, with general `d`
/// and `h(q) = k + a.q`.
///
/// Without that equation the roots form a curve, which a value of the coordinate cuts in a plane. Planes of one
/// coordinate are special: a curve may run off to infinity along them. A general plane, with `p = 1`, cuts it in as
/// many points as its degree. As it turns with `t` about the place where `h` is zero, the sum of `q / h(q)` over all
/// points is linear in `t` (Sommese, Verschelde and Wampler 2002, in the coordinates in which planes of one `t` are
/// parallel). Roots far away contribute to that sum, and no more than that.
pub(crate) struct Tilt<const N: usize> {
    /// The row of the equation.
    pub(crate) row: usize,
    /// `d`.
    direction: Vector<N>,
    /// `a`.
    turning: Vector<N>,
    /// `k`: the right-hand side of the row has `t k` in its place.
    pub(crate) away: Complex<f64>,
}

/// The plane that cuts the curve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Plane {
    /// `p`.
    pub(crate) tilted: f64,
    /// `t`.
    pub(crate) turned: Complex<f64>,
}

impl Plane {
    /// `self + k other`.
    pub(crate) fn plus(self, other: Self, k: f64) -> Self {
        Self {
            tilted: self.tilted + k * other.tilted,
            turned: self.turned + other.turned * k,
        }
    }
}

impl<const N: usize> Tilt<N> {
    /// A tilt for a linkage of the given size.
    pub(crate) fn new(row: usize, size: f64, random: &mut Random) -> Self {
        Self {
            row,
            direction: random.vector(1.0),
            turning: random.vector(1.0),
            away: random.vector::<1>(size).x,
        }
    }

    /// `p d - t a`.
    fn gradient(&self, plane: Plane) -> Vector<N> {
        self.direction * Complex::from(plane.tilted) - self.turning * plane.turned
    }

    /// Adds `(p d - t a).q` to right-hand sides or residuals.
    pub(crate) fn add(&self, plane: Plane, q: &Vector<N>, rows: &mut Vector<N>) {
        rows[self.row] += self.gradient(plane).dot(q);
    }

    /// Adds `p d - t a` to the Jacobian.
    pub(crate) fn add_gradient(&self, plane: Plane, jacobian: &mut SMatrix<Complex<f64>, N, N>) {
        let row = jacobian.row_mut(self.row).into_iter();
        for (entry, gradient) in row.zip(&self.gradient(plane)) {
            *entry += gradient;
        }
    }

    /// `q / h(q)`.
    pub(crate) fn seen(&self, q: &Vector<N>) -> Vector<N> {
        q / (self.away + self.turning.dot(q))
    }
}
