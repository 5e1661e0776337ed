//! Dense LU factorisation with partial pivoting: `P A = L U`.

use core::ops::Range;

use nalgebra::{SMatrix, SVector};

use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Factors;
use crate::listing::Part;

/// The number of unknowns up to which elimination does not look for the columns in which a row is zero: on a controller the
/// test is not worth its code.
const SMALL: usize = 30;

/// The factors of an `N x N` matrix.
///
/// Columns are stored contiguously: `L` below the diagonal (without its diagonal of ones), `U` on and above it.
#[derive(Clone, Copy, Debug)]
pub struct Lu<T, const N: usize> {
    columns: [[T; N]; N],
    swaps: [usize; N],
    smallest: (usize, T),
    positive: bool,
}

impl<T: Real, const N: usize> Lu<T, N> {
    /// Factors `matrix`.
    ///
    /// # Errors
    ///
    /// [`SolveError::Singular`] if the largest candidate for a pivot is at most `N * EPSILON` times the largest entry
    /// of the matrix. A NaN is passed on to the solutions.
    pub fn factor(matrix: &SMatrix<T, N, N>) -> Result<Self, SolveError<T>> {
        let mut lu = Self::unfactored(*matrix);
        lu.eliminate()?;
        Ok(lu)
    }

    /// A matrix that is not factored yet.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn unfactored(matrix: SMatrix<T, N, N>) -> Self {
        Self {
            columns: matrix.data.0,
            swaps: [0; N],
            smallest: (0, T::zero()),
            positive: true,
        }
    }

    /// Factors the matrix in place: on a small stack there is no room for two. Errors as in [`factor`](Self::factor).
    #[inline(never)]
    pub(crate) fn eliminate(&mut self) -> Result<(), SolveError<T>> {
        let entries = self.columns.as_flattened().iter();
        let largest = entries.fold(T::zero(), |largest, entry| largest.max(entry.abs()));
        let threshold = largest * T::EPSILON * T::constant(N as f64);
        self.smallest.1 = largest;
        for k in 0..N {
            let (row, pivot) = self.largest_candidate(k);
            if pivot <= threshold {
                return Err(SolveError::Singular {
                    part: Part::Unknown(k),
                    pivot,
                    threshold,
                });
            }
            if pivot < self.smallest.1 {
                self.smallest = (k, pivot);
            }
            self.swap_rows(k, row);
            self.eliminate_below(k);
        }
        Ok(())
    }

    /// Factors a Jacobian in place; its pivots must exceed `threshold`.
    ///
    /// # Errors
    ///
    /// [`SolveError::Singular`], and [`SolveError::NotFinite`] if an entry is not finite.
    pub(crate) fn eliminate_jacobian(&mut self, threshold: T) -> Result<(), SolveError<T>> {
        for column in &self.columns {
            if let Some(equation) = column.iter().position(|entry| !entry.is_finite()) {
                return Err(SolveError::not_finite(equation));
            }
        }
        self.eliminate()?;
        let (unknown, pivot) = self.smallest;
        if pivot > threshold {
            Ok(())
        } else {
            Err(SolveError::Singular {
                part: Part::Unknown(unknown),
                pivot,
                threshold,
            })
        }
    }

    /// The size of the smallest pivot.
    pub fn smallest_pivot(&self) -> T {
        self.smallest.1
    }

    /// The row and size of the largest entry of column `k` on or below the diagonal.
    fn largest_candidate(&self, k: usize) -> (usize, T) {
        let mut best = (k, T::zero());
        let candidates = self.columns.get(k).and_then(|column| column.get(k..));
        for (row, entry) in (k..).zip(candidates.into_iter().flatten()) {
            let size = entry.abs();
            if size > best.1 {
                best = (row, size);
            }
        }
        best
    }

    fn swap_rows(&mut self, k: usize, row: usize) {
        if let Some(swap) = self.swaps.get_mut(k) {
            *swap = row;
        }
        self.positive ^= row != k;
        for column in &mut self.columns {
            swap(column, k, row);
        }
    }

    /// Subtracts multiples of row `k` from the rows below it.
    fn eliminate_below(&mut self, k: usize) {
        let mut columns = self.columns.iter_mut().skip(k);
        let Some(pivot_column) = columns.next() else {
            return;
        };
        let mut below = pivot_column.iter_mut().skip(k);
        let Some(pivot) = below.next() else { return };
        self.positive ^= *pivot < T::zero();
        let inverse = T::one() / *pivot;
        below.for_each(|entry| *entry *= inverse);
        for column in columns {
            let is_zero = |entry: &T| *entry == T::zero();
            if N <= SMALL || !column.get(k).is_some_and(is_zero) {
                subtract_multiple(column, pivot_column, k);
            }
        }
    }

    /// Solves `A x = b`.
    #[inline(never)]
    pub fn solve(&self, b: &SVector<T, N>) -> SVector<T, N> {
        let [mut x] = b.data.0;
        for (k, row) in self.swaps.iter().enumerate() {
            swap(&mut x, k, *row);
        }
        for (k, column) in self.columns.iter().enumerate() {
            subtract_multiple(&mut x, column, k);
        }
        for (k, column) in self.columns.iter().enumerate().rev() {
            let (Some([above @ .., value]), Some([upper @ .., pivot])) =
                (x.get_mut(..=k), column.get(..=k))
            else {
                continue;
            };
            *value /= *pivot;
            for (entry, upper) in above.iter_mut().zip(upper) {
                *entry -= *upper * *value;
            }
        }
        SVector::from(x)
    }

    /// Solves `A^T y = b`.
    pub fn solve_transposed(&self, b: &SVector<T, N>) -> SVector<T, N> {
        let [mut y] = b.data.0;
        for (k, column) in self.columns.iter().enumerate() {
            let known = sum_of_products(&y, column, 0..k);
            if let (Some(value), Some(pivot)) = (y.get_mut(k), column.get(k)) {
                *value = (*value - known) / *pivot;
            }
        }
        for (k, column) in self.columns.iter().enumerate().rev() {
            let known = sum_of_products(&y, column, k + 1..N);
            if let Some(value) = y.get_mut(k) {
                *value -= known;
            }
        }
        for (k, row) in self.swaps.iter().enumerate().rev() {
            swap(&mut y, k, *row);
        }
        SVector::from(y)
    }
}

impl<T: Real, const N: usize> Factors<T, N> for Lu<T, N> {
    fn solve(&self, right: &SVector<T, N>) -> SVector<T, N> {
        Lu::solve(self, right)
    }

    fn solve_transposed(&self, right: &SVector<T, N>) -> SVector<T, N> {
        Lu::solve_transposed(self, right)
    }

    fn determinant_sign(&self) -> T {
        if self.positive { T::one() } else { -T::one() }
    }

    fn growth_squared(&self) -> T {
        let diagonal = self.columns.iter().enumerate();
        let pivots = diagonal.filter_map(|(k, column)| column.get(k));
        pivots.fold(T::zero(), |sum, pivot| sum + T::one() / (*pivot * *pivot))
    }
}

/// The scalar product of two arrays within a range.
fn sum_of_products<T: Real, const N: usize>(a: &[T; N], b: &[T; N], range: Range<usize>) -> T {
    let (a, b) = (a.get(range.clone()), b.get(range));
    let pairs = a.into_iter().flatten().zip(b.into_iter().flatten());
    pairs.fold(T::zero(), |sum, (a, b)| sum + *a * *b)
}

fn swap<T: Copy, const N: usize>(array: &mut [T; N], i: usize, j: usize) {
    if let (Some(a), Some(b)) = (array.get(i).copied(), array.get(j).copied()) {
        if let Some(entry) = array.get_mut(i) {
            *entry = b;
        }
        if let Some(entry) = array.get_mut(j) {
            *entry = a;
        }
    }
}

/// Subtracts `target[k] * multipliers` from `target`, below entry `k`.
fn subtract_multiple<T: Real, const N: usize>(target: &mut [T; N], multipliers: &[T; N], k: usize) {
    let (Some([factor, below @ ..]), Some([_, multipliers @ ..])) =
        (target.get_mut(k..), multipliers.get(k..))
    else {
        return;
    };
    for (entry, multiplier) in below.iter_mut().zip(multipliers) {
        *entry -= *multiplier * *factor;
    }
}
