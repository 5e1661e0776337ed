//! The needs of a scene, and the methods that meet them.

use suspension_core::step::bounded::Outputs;

use crate::bake::Wish;
use crate::detail::method::Method;

/// What a part of a scene needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Need {
    /// How far a point may be off, m.
    pub tolerance: f64,
    /// What is read.
    pub outputs: Outputs,
    /// Of which points.
    pub points: Wish,
    /// From one instant to the next, s.
    pub step: f64,
}

/// A method and what it was measured to cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detail {
    /// The method.
    pub method: Method,
    /// What it computes.
    pub outputs: Outputs,
    /// Of which points.
    pub points: Wish,
    /// Time a step and suspension, ns.
    pub nanoseconds: f64,
    /// The largest error of a position, m.
    pub error: f64,
}
