//! One configuration: from a rough guess to a position, its velocity and acceleration.

pub mod assemble;
pub mod factored;
pub mod lu;
pub mod motion;
pub mod newton;
pub mod pivots;
pub mod report;
pub mod tolerance;
