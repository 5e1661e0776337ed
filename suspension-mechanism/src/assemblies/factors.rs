//! Complex matrices, factored: `P A = L U`. The core's are of real numbers.

use nalgebra::{Complex, ComplexField, SMatrix, SVector};

/// The factors of a matrix: `L` below the diagonal, its own diagonal of ones left out, `U` on and above it.
pub(crate) struct Factors<const N: usize> {
    factors: SMatrix<Complex<f64>, N, N>,
    /// The row with which each one was swapped.
    swaps: [usize; N],
}

impl<const N: usize> Factors<N> {
    /// Factors a matrix, with partial pivoting.
    pub(crate) fn of(mut matrix: SMatrix<Complex<f64>, N, N>) -> Self {
        let mut swaps = [0; N];
        for (k, swap) in swaps.iter_mut().enumerate() {
            let size = |row: &usize| matrix[(*row, k)].norm1();
            let pivot_row = (k..N).max_by(|a, b| size(a).total_cmp(&size(b)));
            *swap = pivot_row.unwrap_or(k);
            matrix.swap_rows(k, *swap);
            let inverse = matrix[(k, k)].inv();
            for row in k + 1..N {
                matrix[(row, k)] *= inverse;
            }
            for column in k + 1..N {
                let above = matrix[(k, column)];
                for row in k + 1..N {
                    let multiple = matrix[(row, k)];
                    matrix[(row, column)] -= multiple * above;
                }
            }
        }
        Self {
            factors: matrix,
            swaps,
        }
    }

    /// Solves `A x = right`; `None` where a pivot is zero.
    pub(crate) fn solve(
        &self,
        right: &SVector<Complex<f64>, N>,
    ) -> Option<SVector<Complex<f64>, N>> {
        let mut x = *right;
        for (k, swap) in self.swaps.iter().enumerate() {
            x.swap_rows(k, *swap);
        }
        for k in 0..N {
            for row in k + 1..N {
                let known = x[k];
                x[row] -= self.factors[(row, k)] * known;
            }
        }
        for k in (0..N).rev() {
            let pivot = self.factors[(k, k)];
            if pivot == Complex::ZERO {
                return None;
            }
            x[k] /= pivot;
            for row in 0..k {
                let known = x[k];
                x[row] -= self.factors[(row, k)] * known;
            }
        }
        Some(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Matrix = SMatrix<Complex<f64>, 4, 4>;

    /// Zeros on the diagonal, so that rows must be swapped.
    fn matrix() -> Matrix {
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
