//! A matrix filled row by row, in which the entries of a row are stated by points.

use nalgebra::{ArrayStorage, Matrix3, SMatrix, Vector3};

use crate::arithmetic::scalar::Scalar;

/// The rows of an `N x N` matrix, zero at first.
pub struct Rows<T, const N: usize> {
    columns: [[T; N]; N],
}

/// One of these rows, or the first of three where a method says so. The column of a point is the column of its first
/// coordinate.
pub struct Row<'a, T, const N: usize> {
    columns: &'a mut [[T; N]; N],
    row: usize,
}

impl<T: Scalar, const N: usize> Rows<T, N> {
    /// All zero.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn zero() -> Self {
        Self {
            columns: [[T::zero(); N]; N],
        }
    }

    /// The row with an index.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn at(&mut self, row: usize) -> Row<'_, T, N> {
        Row {
            columns: &mut self.columns,
            row,
        }
    }

    /// The matrix.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn matrix(self) -> SMatrix<T, N, N> {
        SMatrix::from_array_storage(ArrayStorage(self.columns))
    }
}

impl<T: Scalar, const N: usize> Row<'_, T, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn put(&mut self, below: usize, column: usize, entry: T) {
        let column = self.columns.get_mut(column);
        if let Some(place) = column.and_then(|column| column.get_mut(self.row + below)) {
            *place = entry;
        }
    }

    /// Sets the derivative of the row with respect to one unknown.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn by_one(mut self, column: usize, entry: T) -> Self {
        self.put(0, column, entry);
        self
    }

    /// Sets the derivative of the row with respect to a point.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn by(self, column: usize, entries: Vector3<T>) -> Self {
        self.by_one(column, entries.x)
            .by_one(column + 1, entries.y)
            .by_one(column + 2, entries.z)
    }

    /// Sets the derivatives of three rows with respect to one unknown.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn three_by_one(mut self, column: usize, entries: Vector3<T>) -> Self {
        self.put(0, column, entries.x);
        self.put(1, column, entries.y);
        self.put(2, column, entries.z);
        self
    }

    /// Sets the derivatives of three rows with respect to a point. A loop would keep the matrix in memory, and stacks
    /// are small.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn three_by(self, column: usize, entries: Matrix3<T>) -> Self {
        let [[xx, yx, zx], [xy, yy, zy], [xz, yz, zz]] = entries.data.0;
        self.three_by_one(column, Vector3::new(xx, yx, zx))
            .three_by_one(column + 1, Vector3::new(xy, yy, zy))
            .three_by_one(column + 2, Vector3::new(xz, yz, zz))
    }

    /// Sets the derivatives of three rows with respect to a point to a multiple of the identity.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn diagonal_by(mut self, column: usize, factor: T) -> Self {
        self.put(0, column, factor);
        self.put(1, column + 1, factor);
        self.put(2, column + 2, factor);
        self
    }
}
