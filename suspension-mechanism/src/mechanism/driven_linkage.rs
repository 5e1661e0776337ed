//! A linkage in the configuration of the first instant, with its drives over time.

use std::ops::Deref;

use suspension_core::{Motion, Values};

use crate::mechanism::derivatives::design_derivatives::DesignDerivatives;
use crate::mechanism::description::Description;
use crate::mechanism::motion::drive_laws::inputs_at_rest;
use crate::mechanism::motion::lead::Lead;
use crate::mechanism::suspension::Suspension;

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

impl<L: Suspension<N>, const N: usize> Mechanism<L, N> {
    /// The drives at the first instant.
    pub(crate) fn start_drives(&self) -> L::Drives {
        L::Drives::from_values(self.first_drives())
    }

    /// All points at the first instant, in local coordinates.
    pub(crate) fn start_points(&self) -> L::Points {
        let inputs = inputs_at_rest(self.start_drives());
        self.start.points(&self.model, &inputs).value
    }
}
