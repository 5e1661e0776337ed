//! The operations of a step, counted by a number type that records them.

mod headers;
mod number;
mod step;

use nalgebra::{SVector, Vector3};
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::{Listing, Values};

use crate::support;
use number::Counting;

fn attia_model() -> attia2003::Model<Counting> {
    attia2003::Listing::converted(&support::attia_model::<f64>(), |_| Counting::unknown())
}

fn five_link_model() -> five_link::Model<Counting> {
    five_link::Listing::converted(&support::five_link_model::<f64>(), |_| Counting::unknown())
}

fn unknowns<const N: usize>() -> SVector<Counting, N> {
    SVector::from_fn(|_, _| Counting::unknown())
}

/// Chassis points, somewhere.
fn chassis<F: Values<Vector3<Counting>>>() -> F {
    F::from_values(std::iter::repeat_with(|| {
        Vector3::from_fn(|_, _| Counting::unknown())
    }))
}
