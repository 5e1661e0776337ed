//! Tests that solve millions of equations. They are a package of their own, since it takes less time to
//! optimise and run them than to run them as they are.

mod assembly;
mod baked;
mod bounded;
mod certificate;
mod curves;
#[path = "../support/double_wishbone.rs"]
mod double_wishbone;
mod f32;
mod guard;
mod hostile;
mod properties;
mod series;
mod stack;
#[path = "../support/mod.rs"]
mod support;

use nalgebra::{SMatrix, SVector};
use proptest::test_runner::Config;
use suspension_core::solve::lu::Lu;

/// The settings for a number of random cases; a failing one is printed, not written to a file.
fn config(cases: u32) -> Config {
    Config {
        cases,
        failure_persistence: None,
        ..Config::default()
    }
}

/// The norm of a matrix' inverse; `None` where it has none.
fn inverse_norm(matrix: &SMatrix<f64, 15, 15>) -> Option<f64> {
    let factored = Lu::factor(matrix).ok()?;
    let column = |place| factored.solve(&SVector::from_fn(|row, _| f64::from(row == place)));
    let squares = (0..15).map(|place| column(place).norm_squared());
    Some(squares.sum::<f64>().sqrt())
}
