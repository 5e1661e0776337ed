//! The kinematic characteristics of a suspension: quantities at the design position with their derivatives, and curves
//! over travel and steering.

mod along;
mod curves;
mod parameters;

pub use along::{Along, Span, Way, ways};
pub use curves::{Curves, Line, curves};
pub use parameters::{Derivative, Parameter, parameters};
