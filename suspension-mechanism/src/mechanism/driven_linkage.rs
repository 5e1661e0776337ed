//! A linkage in the configuration of the first instant, with its drives over time.

use std::ops::Deref;

use suspension_core::Motion;

use crate::mechanism::derivatives::design_derivatives::DesignDerivatives;
use crate::mechanism::description::Description;
use crate::mechanism::motion::lead::Lead;

/// Gives a mechanism at its start, with how it changes with its design; `None` if it locks there.
pub type FindDesignDerivatives<L, const N: usize> =
    for<'a> fn(&'a Mechanism<L, N>) -> Option<Box<dyn DesignDerivatives + 'a>>;

/// A linkage in the configuration of the first instant, with its drives over time. It can be read as its
/// [`Description`].
#[derive(Clone, Debug)]
pub struct Mechanism<L, const N: usize> {
    /// The data of the mechanism without its equations.
    pub description: Description,
    /// The geometry.
    pub model: L,
    /// The configuration at the first instant.
    pub start: Motion<f64, N>,
    /// The measure that leads instead of a drive.
    pub lead: Option<Lead<N>>,
    /// The change of the mechanism with its design, if its model provides it.
    pub design_derivatives: Option<FindDesignDerivatives<L, N>>,
}

impl<L, const N: usize> Deref for Mechanism<L, N> {
    type Target = Description;

    fn deref(&self) -> &Description {
        &self.description
    }
}
