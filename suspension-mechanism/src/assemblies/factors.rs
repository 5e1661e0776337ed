//! Complex matrices, factored: `P A = L U`. The core's are of real numbers.

use std::array;
use std::ops::Range;

use nalgebra::{Complex, ComplexField, SMatrix, SVector};

/// Unknowns, right-hand sides and residuals.
pub(crate) type Vector<const N: usize> = SVector<Complex<f64>, N>;

type Matrix<const N: usize> = SMatrix<Complex<f64>, N, N>;

/// The factors of a matrix: `L` below the diagonal, its own diagonal of ones left out, `U` on and above it. Most of their
/// entries are zero, as those of the matrix are.
pub(crate) struct Factors<const N: usize> {
    factors: Matrix<N>,
    /// The row with which each one was swapped.
    swaps: [usize; N],
    /// Of each column, the rows below the diagonal that are not zero.
    below: [Rows<N>; N],
    /// The same above it.
    above: [Rows<N>; N],
}

/// Some of the rows.
struct Rows<const N: usize> {
    rows: [usize; N],
    count: usize,
}

impl<const N: usize> Rows<N> {
    /// Those of a range that are not zero in a column.
    fn of(matrix: &Matrix<N>, range: Range<usize>, column: usize) -> Self {
        let (mut rows, mut count) = ([0; N], 0);
        for row in range.filter(|row| matrix[(*row, column)] != Complex::ZERO) {
            rows[count] = row;
            count += 1;
        }
        Self { rows, count }
    }

    fn iter(&self) -> impl Iterator<Item = usize> {
        self.rows[..self.count].iter().copied()
    }
}

impl<const N: usize> Factors<N> {
    /// Factors a matrix, with partial pivoting.
    pub(crate) fn of(mut matrix: Matrix<N>) -> Self {
        let mut swaps = [0; N];
        for (k, swap) in swaps.iter_mut().enumerate() {
            let size = |row: &usize| matrix[(*row, k)].norm1();
            let pivot_row = (k..N).max_by(|a, b| size(a).total_cmp(&size(b)));
            *swap = pivot_row.unwrap_or(k);
            matrix.swap_rows(k, *swap);
            let below = Rows::of(&matrix, k + 1..N, k);
            let inverse = matrix[(k, k)].inv();
            for row in below.iter() {
                matrix[(row, k)] *= inverse;
            }
            for column in k + 1..N {
                let above = matrix[(k, column)];
                if above == Complex::ZERO {
                    continue;
                }
                for row in below.iter() {
                    let multiple = matrix[(row, k)];
                    matrix[(row, column)] -= multiple * above;
                }
            }
        }
        Self {
            swaps,
            below: array::from_fn(|column| Rows::of(&matrix, column + 1..N, column)),
            above: array::from_fn(|column| Rows::of(&matrix, 0..column, column)),
            factors: matrix,
        }
    }

    /// Solves `A x = right`; `None` where a pivot is zero.
    pub(crate) fn solve(&self, right: &Vector<N>) -> Option<Vector<N>> {
        let mut x = *right;
        for (k, swap) in self.swaps.iter().enumerate() {
            x.swap_rows(k, *swap);
        }
        for (column, below) in self.below.iter().enumerate() {
            let known = x[column];
            for row in below.iter() {
                x[row] -= self.factors[(row, column)] * known;
            }
        }
        for (column, above) in self.above.iter().enumerate().rev() {
            let pivot = self.factors[(column, column)];
            if pivot == Complex::ZERO {
                return None;
            }
            let known = x[column] / pivot;
            x[column] = known;
            for row in above.iter() {
                x[row] -= self.factors[(row, column)] * known;
            }
        }
        Some(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Zeros on the diagonal, so that rows must be swapped.
    fn matrix() -> Matrix<4> {
        Matrix::from_fn(|row, column| {
            let (r, c) = (row as f64, column as f64);
            Complex::new((r - c) * (1.0 + c), (r * r - c * c) * 0.3)
        }) + Matrix::from_fn(|row, column| Complex::from(f64::from(u8::from(row + column == 3))))
    }

    #[test]
    fn what_is_solved_is_met() {
        let x = SVector::from_fn(|row, _| Complex::new(row as f64 - 1.5, 2.0 - row as f64));
        let found = Factors::of(matrix())
            .solve(&(matrix() * x))
            .expect("regular");
        assert!((found - x).camax() < 1e-13, "{found}");
    }

    #[test]
    fn a_singular_matrix_has_no_solution() {
        let mut singular = matrix();
        singular.set_row(2, &singular.row(0).into_owned());
        singular.set_column(1, &SVector::zeros());
        assert!(Factors::of(singular).solve(&SVector::zeros()).is_none());
    }
}
