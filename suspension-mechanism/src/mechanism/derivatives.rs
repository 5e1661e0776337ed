//! Derivatives of a mechanism at a place: with respect to its drives, and along changes of its design.

pub(super) mod design_derivatives;
pub(super) mod gradient;
pub(super) mod local_motion;
pub(super) mod place_data;
mod point_derivatives;
pub(super) mod positions;
pub(super) mod sensitive;
