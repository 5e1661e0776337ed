//! Complex matrices, factored: `P A = L U`. The core's are of real numbers.

use std::ops::Range;

use nalgebra::{Complex, SMatrix, SVector};
use suspension_core::Scalar;

/// Unknowns, right-hand sides and residuals.
pub(crate) type Vector<const N: usize> = SVector<Complex<f64>, N>;

type Matrix<const N: usize> = SMatrix<Complex<f64>, N, N>;

/// The equations that are solved together, and their unknowns. Each of the other unknowns is given by an equation
/// that states its value.
pub(crate) struct Solved {
    rows: Vec<usize>,
    columns: Vec<usize>,
    /// The other equations, each with its unknown.
    given: Vec<[usize; 2]>,
}

impl Solved {
    /// A part's `own` equations, together with equation `and` of the `others`, in which the value of a given unknown is
    /// not alone; all with their unknowns.
    pub(crate) fn new(own: &[[usize; 2]], others: &[[usize; 2]], and: Option<usize>) -> Self {
        let others = others.iter().copied();
        let (with_others, given): (Vec<_>, Vec<_>) = others.partition(|[row, _]| Some(*row) == and);
        let together = own.iter().chain(&with_others);
        let (rows, columns) = together.map(|[row, column]| (*row, *column)).unzip();
        Self {
            rows,
            columns,
            given,
        }
    }

    /// The non-zero entries of given unknowns in the equations that are solved together: place of the equation,
    /// unknown, entry.
    fn given_entries<const N: usize>(
        &self,
        jacobian: &Matrix<N>,
    ) -> Vec<(usize, usize, Complex<f64>)> {
        let given = self.given.iter().flat_map(|[_, column]| {
            let rows = self.rows.iter().enumerate();
            rows.map(|(place, row)| (place, *column, jacobian[(*row, *column)]))
        });
        given
            .filter(|(.., entry)| *entry != Complex::ZERO)
            .collect()
    }
}

/// The factors of the equations that are solved together: `L`, without its diagonal of ones, and `U`. Most of their
/// entries are zero, as are those of the matrix.
pub(crate) struct Factors<'s> {
    solved: &'s Solved,
    given_entries: Vec<(usize, usize, Complex<f64>)>,
    /// The row with which each row was swapped.
    swaps: Vec<usize>,
    /// The inverses of the non-zero pivots.
    inverses: Vec<Complex<f64>>,
    below: Columns,
    above: Columns,
}

/// Non-zero entries with their rows, column after column.
struct Columns {
    entries: Vec<(usize, Complex<f64>)>,
    ends: Vec<usize>,
}

impl Columns {
    fn with_capacity(columns: usize) -> Self {
        Self {
            entries: Vec::with_capacity(columns * columns),
            ends: Vec::with_capacity(columns),
        }
    }

    fn push(&mut self, column: &[Complex<f64>], rows: Range<usize>) {
        for row in rows {
            if column[row] != Complex::ZERO {
                self.entries.push((row, column[row]));
            }
        }
        self.ends.push(self.entries.len());
    }

    fn subtract(&self, column: usize, times: Complex<f64>, from: &mut [Complex<f64>]) {
        let start = column.checked_sub(1).map_or(0, |last| self.ends[last]);
        for (row, entry) in &self.entries[start..self.ends[column]] {
            from[*row] = from[*row].minus_product(*entry, times);
        }
    }
}

impl<'s> Factors<'s> {
    /// Factors the rows of `jacobian` that are solved together, with partial pivoting.
    pub(crate) fn compute<const N: usize>(jacobian: &Matrix<N>, solved: &'s Solved) -> Self {
        let Solved { rows, columns, .. } = solved;
        let count = rows.len();
        let mut matrix = Vec::with_capacity(count * count);
        for column in columns {
            let entries = &jacobian.data.0[*column];
            matrix.extend(rows.iter().map(|row| entries[*row]));
        }
        let swaps = eliminate(&mut matrix, count);
        let (mut below, mut above) = (Columns::with_capacity(count), Columns::with_capacity(count));
        let mut inverses = Vec::with_capacity(count);
        for (place, column) in matrix.chunks_exact(count).enumerate() {
            above.push(column, 0..place);
            below.push(column, place + 1..count);
            inverses.extend((column[place] != Complex::ZERO).then(|| column[place].inv()));
        }
        Self {
            solved,
            given_entries: solved.given_entries(jacobian),
            swaps,
            inverses,
            below,
            above,
        }
    }

    /// Solves `J x = right`; `None` if a pivot is zero.
    pub(crate) fn solve<const N: usize>(&self, right: &Vector<N>) -> Option<Vector<N>> {
        if self.inverses.len() < self.swaps.len() {
            return None;
        }
        let mut solution = Vector::zeros();
        for &[row, column] in &self.solved.given {
            solution[column] = right[row];
        }
        let mut x = [Complex::ZERO; N];
        for (x, row) in x.iter_mut().zip(&self.solved.rows) {
            *x = right[*row];
        }
        for (place, column, entry) in &self.given_entries {
            x[*place] -= entry * solution[*column];
        }
        for (k, swap) in self.swaps.iter().enumerate() {
            x.swap(k, *swap);
        }
        for column in 0..self.swaps.len() {
            self.below.subtract(column, x[column], &mut x);
        }
        for (column, inverse) in self.inverses.iter().enumerate().rev() {
            x[column] *= inverse;
            self.above.subtract(column, x[column], &mut x);
        }
        for (column, x) in self.solved.columns.iter().zip(x) {
            solution[*column] = x;
        }
        Some(solution)
    }
}

/// Writes `L` below the diagonal of a matrix of `count` rows, given column by column, and `U` on and above it;
/// returns the row with which each row was swapped.
fn eliminate(entries: &mut [Complex<f64>], count: usize) -> Vec<usize> {
    let mut swaps = Vec::with_capacity(count);
    let mut below = Vec::with_capacity(count);
    for k in 0..count {
        let sizes = entries[k * count..][k..count].iter().map(Complex::l1_norm);
        let largest = sizes.enumerate().max_by(|(_, a), (_, b)| a.total_cmp(b));
        let swap = k + largest.map_or(0, |(place, _)| place);
        swaps.push(swap);
        for column in entries.chunks_exact_mut(count) {
            column.swap(k, swap);
        }
        let (done, others) = entries.split_at_mut((k + 1) * count);
        let column = &mut done[k * count..];
        let inverse = column[k].inv();
        below.clear();
        below.extend((k + 1..count).filter(|row| column[*row] != Complex::ZERO));
        for row in &below {
            column[*row] *= inverse;
        }
        for other in others.chunks_exact_mut(count) {
            let above = other[k];
            if above != Complex::ZERO {
                for row in &below {
                    other[*row] = other[*row].minus_product(column[*row], above);
                }
            }
        }
    }
    swaps
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

    const ALL: [[usize; 2]; 4] = [[0, 0], [1, 1], [2, 2], [3, 3]];

    #[test]
    fn complex_factors_solve_all_or_some_of_the_equations() {
        let x = SVector::from_fn(|row, _| Complex::new(row as f64 - 1.5, 2.0 - row as f64));
        let right = matrix() * x;
        let all = Solved::new(&ALL, &[], None);
        let found = Factors::compute(&matrix(), &all)
            .solve(&right)
            .expect("regular");
        assert!((found - x).camax() < 1e-13, "{found}");
        // Equations 1 and 3 give unknowns 2 and 0, equation 3 among the others.
        let some = Solved::new(&[[0, 3], [2, 1]], &[[1, 2], [3, 0]], Some(3));
        let given = Vector::from([right[0], x[2], right[2], right[3]]);
        let found = Factors::compute(&matrix(), &some)
            .solve(&given)
            .expect("regular");
        assert!((found - x).camax() < 1e-13, "{found}");
    }

    #[test]
    fn a_singular_matrix_has_no_solution() {
        let mut singular = matrix();
        singular.set_row(2, &singular.row(0).into_owned());
        singular.set_column(1, &SVector::zeros());
        let all = Solved::new(&ALL, &[], None);
        assert!(
            Factors::compute(&singular, &all)
                .solve(&Vector::<4>::zeros())
                .is_none()
        );
    }
}
