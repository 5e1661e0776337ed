//! One configuration: from a rough guess to a position, its velocity and acceleration.
//!
//! [`assemble()`](crate::assemble) finds the configuration nearest to a guess, [`Newton`](crate::Newton) corrects a position that is close
//! already, and [`Tangent`](crate::Tangent) has the velocity and acceleration there. What moves is kept in a
//! [`Motion`](crate::Motion); a [`Report`](report::Report) says what was done, a [`Tolerance`](tolerance::Tolerance) how small a
//! residual must be. Beneath them is elimination: [`factored`], [`lu`], [`pivots`].

pub mod assemble;
pub mod factored;
pub mod lu;
pub mod motion;
pub mod newton;
pub mod pivots;
pub mod report;
pub mod tolerance;
