//! Small vibrations, of a linear model and as measured.

use nalgebra::{DMatrix, SMatrix, SVector, SymmetricEigen};

/// The modes of `M x'' + K x = 0`, slowest first: frequency in Hz and shape, of length 1.
pub(crate) fn modes<const N: usize>(
    mass: SMatrix<f64, N, N>,
    stiffness: SMatrix<f64, N, N>,
) -> Vec<(f64, SVector<f64, N>)> {
    let on_heap = |matrix: SMatrix<f64, N, N>| DMatrix::from_column_slice(N, N, matrix.as_slice());
    let lower = on_heap(mass).cholesky().expect("masses").l();
    let inverse = lower.try_inverse().expect("masses");
    let transposed = inverse.transpose();
    let eigen = SymmetricEigen::new(&inverse * on_heap(stiffness) * &transposed);
    let shape = |mode: usize| (&transposed * eigen.eigenvectors.column(mode)).normalize();
    let shapes = (0..N).map(|mode| SVector::from_column_slice(shape(mode).as_slice()));
    let frequencies = eigen
        .eigenvalues
        .iter()
        .map(|square| square.max(0.0).sqrt() / std::f64::consts::TAU);
    let mut modes: Vec<_> = frequencies.zip(shapes).collect();
    modes.sort_by(|a, b| a.0.total_cmp(&b.0));
    modes
}

/// The frequency of samples at intervals of `dt`: from the first and the last time at which they rise through zero.
pub(crate) fn frequency(samples: &[f64], dt: f64) -> f64 {
    let rises: Vec<f64> = samples
        .windows(2)
        .enumerate()
        .filter(|(_, pair)| pair[0] < 0.0 && pair[1] >= 0.0)
        .map(|(at, pair)| at as f64 + pair[0] / (pair[0] - pair[1]))
        .collect();
    let [first, last] = [rises[0], rises[rises.len() - 1]];
    (rises.len() - 1) as f64 / ((last - first) * dt)
}
