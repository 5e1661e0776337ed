//! The published mechanism in both listings, at its first instant.

use nalgebra::SVector;
use suspension_core::path::{Continuation, Curve, Stretch};
use suspension_core::{Build, Inputs, Newton, Real, Still, assemble};

use crate::support;

/// A listing's model with its configuration at t = 0.
pub(crate) struct Case<T: Real, L: Build<15, Scalar = T>> {
    pub(crate) model: L,
    pub(crate) q: SVector<T, 15>,
    pub(crate) inputs: fn(T) -> Inputs<Still, L::Drives>,
}

impl<T: Real, L: Build<15, Scalar = T>> Case<T, L> {
    fn new(model: L, rough: &L::Points, inputs: fn(T) -> Inputs<Still, L::Drives>) -> Self {
        let mut q = model.unknowns(rough);
        assemble(&Newton::from_afar(), &model, &inputs(T::zero()), &mut q).expect("assembles");
        Self { model, q, inputs }
    }

    pub(crate) fn curve(&self) -> Curve<'_, L, 15> {
        Curve::new(&self.model, &(self.inputs)(T::zero()), 0).expect("a drive")
    }

    /// All stretches from t = 0, first to larger or to smaller angles.
    pub(crate) fn path(&self, increasing: bool) -> Vec<Stretch<T, 15>> {
        let path = Continuation::default().path(self.curve(), &self.q, increasing);
        let stretches = path.expect("a regular start").collect::<Result<_, _>>();
        stretches.expect("a regular curve")
    }
}

pub(crate) fn attia<T: Real>() -> Case<T, suspension_core::linkages::attia2003::Model<T>> {
    Case::new(
        support::attia_model(),
        &support::attia_rough(),
        support::attia_inputs,
    )
}

pub(crate) fn five_link<T: Real>() -> Case<T, suspension_core::linkages::five_link::Model<T>> {
    Case::new(
        support::five_link_model(),
        &support::five_link_rough(),
        support::five_link_inputs,
    )
}
