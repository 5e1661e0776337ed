//! One configuration: from a rough guess to a position, its velocity and acceleration.
//!
//! [`assemble()`](crate::assemble) finds the configuration nearest to a guess, [`Newton`](crate::Newton) corrects a
//! position that is already close, and [`Tangent`](crate::Tangent) has the velocity and acceleration there. A
//! [`Motion`](crate::Motion) holds position, velocity and acceleration; a [`Report`](report::Report) says what was
//! done, a [`Tolerance`](tolerance::Tolerance) how small a residual must be. They use elimination: [`factored`],
//! [`lu`], [`pivots`].

pub mod assemble;
pub mod factored;
pub mod lu;
pub mod motion;
pub mod newton;
pub mod pivots;
pub mod report;
pub mod tolerance;
