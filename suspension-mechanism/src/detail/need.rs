//! The needs of a scene, and the methods that meet them.

use suspension_core::step::bounded::Outputs;

use crate::bake::Wish;
use crate::detail::method::Method;

/// The need of a part of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Need {
    /// The largest permitted error of a point's position, m.
    pub tolerance: f64,
    /// The outputs that are read.
    pub outputs: Outputs,
    /// The points at which they are read.
    pub points: Wish,
    /// The time from one instant to the next, s.
    pub step: f64,
}

/// A method and its measured cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detail {
    /// The method.
    pub method: Method,
    /// The outputs that it computes.
    pub outputs: Outputs,
    /// The points for which it computes them.
    pub points: Wish,
    /// The time per step and suspension, ns.
    pub nanoseconds: f64,
    /// The largest error of a position, m.
    pub error: f64,
}
